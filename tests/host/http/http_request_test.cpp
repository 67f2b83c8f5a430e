// SPDX-License-Identifier: Apache-2.0
// Tests HTTP requests that are valid or invalid and arrive in one piece or several. Their length is always bounded.
#include "host/http/http_request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

HttpRequest read(const std::string& text, std::size_t piece = 1000000) {
    HttpRequest request;
    for (std::size_t at = 0; at < text.size(); at += piece) {
        request.take(std::string_view{text}.substr(at, piece));
    }
    return request;
}

/// Returns the status of the refusal; 0 for a valid request, -1 for an incomplete one.
int status(const std::string& text) {
    const HttpRequest request = read(text);
    return request.refusal() ? request.refusal()->status : request.is_done() ? 0 : -1;
}

const std::string start = "GET / HTTP/1.1\r\nHost: localhost\r\n";
const std::string post =
    "POST /api/frame HTTP/1.1\r\nHost: localhost:8404\r\norigin:http://localhost:8404\r\nSec-Fetch-Site: same-origin "
    "\r\n"
    "CONTENT-TYPE:\tapplication/json\r\nContent-Length: 7\r\n\r\n{\"a\":1}";

}  // namespace

TEST(HttpRequest, RequestIsReadTheSameFromPiecesOfAnySize) {
    for (std::size_t piece = 1; piece <= post.size(); ++piece) {
        const HttpRequest request = read(post, piece);
        ASSERT_TRUE(request.is_done());
        EXPECT_EQ(request.request().method, "POST");
        EXPECT_EQ(request.request().path, "/api/frame");
        EXPECT_EQ(request.request().host, "localhost:8404");
        EXPECT_EQ(request.request().origin, "http://localhost:8404");
        EXPECT_EQ(request.request().fetch_site, "same-origin");
        EXPECT_EQ(request.request().content_type, "application/json");
        EXPECT_EQ(request.request().body, "{\"a\":1}");
    }
    EXPECT_FALSE(read(post.substr(0, post.size() - 1)).is_done());
    EXPECT_EQ(read(post + "GET / HTTP/1.1\r\n\r\n").request().path, "/api/frame");
}

TEST(HttpRequest, QueryGivesTheNumbersOfTheFirstChangeAndFirstFrameToReturn) {
    const HttpRequest request = read("GET /api/state?changes=12&frames=18446744073709551615 HTTP/1.1\r\n\r\n");
    EXPECT_EQ(request.request().path, "/api/state");
    EXPECT_EQ(request.request().changes_from, 12U);
    EXPECT_EQ(request.request().frames_from, UINT64_MAX);
    for (const char* odd : {"?", "?changes", "?changes=", "?changes=x", "?changes=-1", "?schanges=3", "?a=1&&b"}) {
        EXPECT_EQ(read(std::string{"GET /"} + odd + " HTTP/1.0\n\n").request().changes_from, 0U) << odd;
    }
}

TEST(HttpRequest, HeadersThatThePanelDoesNotReadAreDropped) {
    std::string ranges = "Range: bytes=0-";
    while (ranges.size() < 7900) {
        ranges += ",0-";
    }
    const HttpRequest request =
        read(start + ranges + "\r\nAccept-Encoding: gzip\r\nIf-Range: x\r\nConnection: upgrade\r\nCookie: a\r\n\r\n");
    ASSERT_TRUE(request.is_done());
    EXPECT_FALSE(request.refusal());
    EXPECT_EQ(request.held(), 0U);
    EXPECT_EQ(request.request().host, "localhost");
}

TEST(HttpRequest, LengthsOfLinesAndHeadAreLimited) {
    const auto line_of = [](std::size_t length) { return "GET /" + std::string(length - 14, 'a') + " HTTP/1.1"; };
    EXPECT_EQ(status(line_of(2048) + "\r\n\r\n"), 0);
    EXPECT_EQ(status(line_of(2049) + "\r\n\r\n"), 414);
    EXPECT_EQ(status(std::string(2049, 'a')), 414);  // refused before the end of the line was received
    const auto header_of = [](std::size_t length) { return "X: " + std::string(length - 3, 'a') + "\r\n"; };
    EXPECT_EQ(status(start + header_of(8192) + "\r\n"), 0);
    EXPECT_EQ(status(start + header_of(8193) + "\r\n"), 431);
    // The head has 16384 bytes. `start` has 33, the first two headers with their line ends have 8002 and 4002. The line
    // end of the third header and the empty line have 2 each.
    const std::string most =
        start + header_of(8000) + header_of(4000) + header_of(16384 - 33 - 8002 - 4002 - 2 - 2) + "\r\n";
    EXPECT_EQ(most.size(), 16384U);
    EXPECT_EQ(status(most), 0);
    EXPECT_EQ(status(start + "A: b\r\n" + most.substr(start.size())), 431);
}

TEST(HttpRequest, BodyHasTheAnnouncedLengthAndIsBounded) {
    const std::string head = "POST / HTTP/1.1\r\nContent-Length: ";
    EXPECT_EQ(status(head + "4096\r\n\r\n" + std::string(4096, ' ')), 0);
    EXPECT_EQ(status(head + "4097\r\n\r\n"), 413);
    EXPECT_EQ(status(head + "99999999999999999999\r\n\r\n"), 413);
    for (const char* odd : {"", "-1", "+1", "1x", "0x10", "1,1", "1 1"}) {
        EXPECT_EQ(status(head + odd + "\r\n\r\n"), 400) << odd;
    }
    EXPECT_EQ(read(head + "0\r\n\r\nmore").request().body, "");
}

TEST(HttpRequest, ChunkedBodyAndExpectHeaderAreRefused) {
    EXPECT_EQ(status(start + "Transfer-Encoding: chunked\r\n\r\n"), 411);
    EXPECT_EQ(status(start + "TRANSFER-ENCODING: identity\r\n\r\n"), 411);
    EXPECT_EQ(status(start + "Expect: 100-continue\r\n\r\n"), 417);
}

TEST(HttpRequest, HeaderUsedToAllowOrRefuseARequestMayOccurOnceOnly) {
    for (const char* name : {"Host", "Origin", "Sec-Fetch-Site", "Content-Type", "Content-Length"}) {
        const std::string header = std::string{name} + ": 1\r\n";
        EXPECT_EQ(status("GET / HTTP/1.1\r\n" + header + header + "\r\n"), 400) << name;
    }
    EXPECT_EQ(status(start + "Accept: a\r\nAccept: b\r\n\r\n"), 0);
}

TEST(HttpRequest, InvalidHttpIsRefused) {
    for (const char* line : {"", "GET", "GET /", "GET  / HTTP/1.1", "GET / HTTP/1.1 ", " GET / HTTP/1.1",
                             "get / HTTP/1.1", "GET http://localhost/ HTTP/1.1", "GET * HTTP/1.1", "GET /\x01 HTTP/1.1",
                             "GET /\x80 HTTP/1.1", "GET /\tx HTTP/1.1", "GET / HTTP/1.1\rX", "G\xC3T / HTTP/1.1"}) {
        EXPECT_EQ(status(std::string{line} + "\r\n\r\n"), 400) << line;
    }
    EXPECT_EQ(status(std::string("GET /\0 HTTP/1.1\r\n", 17)), 400);
    EXPECT_EQ(status("GET / HTTP/2\r\n"), 505);
    EXPECT_EQ(status("GET / http/1.1\r\n"), 505);
    for (const char* header : {"no colon", ": no name", "Host : localhost", " folded: line", "\tfolded", "Ho st: x",
                               "H\xC3st: x", "Host: a\x01", "Host: a\rb"}) {
        EXPECT_EQ(status("GET / HTTP/1.1\r\n" + std::string{header} + "\r\n\r\n"), 400) << header;
    }
    EXPECT_THAT(read("x\r\n").refusal()->body, HasSubstr("error"));
}

}  // namespace canproof::host::test
