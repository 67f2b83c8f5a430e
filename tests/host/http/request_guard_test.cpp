// SPDX-License-Identifier: Apache-2.0
// Tests which HTTP requests the panel accepts or refuses.
#include "host/http/request_guard.hpp"

#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

PanelRequest post_request() {
    PanelRequest request;
    request.method = "POST";
    request.path = "/api/stimulus";
    request.host = "127.0.0.1:8404";
    request.origin = "http://127.0.0.1:8404";
    request.content_type = "application/json";
    request.body = "{}";
    return request;
}

int status(const PanelRequest& request) {
    const auto refusal = refuse(request);
    return refusal ? refusal->status : 0;
}

}  // namespace

TEST(RequestGuard, RequestOfThePanelPageMayChangeTheState) {
    EXPECT_EQ(status(post_request()), 0);
    PanelRequest request = post_request();
    request.fetch_site = "same-origin";
    request.content_type = "application/json; charset=utf-8";
    EXPECT_EQ(status(request), 0);
}

TEST(RequestGuard, RequestOfAProgramWithoutOriginHeaderMayChangeTheState) {
    PanelRequest request = post_request();
    request.origin = "";
    EXPECT_EQ(status(request), 0);
}

TEST(RequestGuard, LoopbackAddressesAndLocalhostAreAccepted) {
    for (const std::string host : {"127.0.0.1:8404", "localhost:8404", "[::1]:8404", "localhost", "[::1]"}) {
        PanelRequest request = post_request();
        request.host = host;
        request.origin = "http://" + host;
        EXPECT_EQ(status(request), 0) << host;
    }
}

TEST(RequestGuard, RequestWithAnotherHostNameIsRefused_EvenForReading) {
    for (const std::string host : {"evil.example:8404", "", "127.0.0.1.evil.example", "localhost.evil.example:8404",
                                   "127.0.0.1:8404@evil.example", "evil.example#127.0.0.1", "10.0.0.1:8404"}) {
        PanelRequest request;
        request.host = host;
        EXPECT_EQ(status(request), 403) << host;
        request = post_request();
        request.host = host;
        request.origin = "http://" + host;
        EXPECT_EQ(status(request), 403) << host;
    }
}

TEST(RequestGuard, RequestFromAnotherOriginIsRefused) {
    for (const std::string origin : {"http://evil.example", "null", "https://127.0.0.1:8404", "http://127.0.0.1:3000",
                                     "http://localhost:8404", "http://127.0.0.1:8404.evil.example"}) {
        PanelRequest request = post_request();
        request.origin = origin;
        EXPECT_EQ(status(request), 403) << origin;
    }
}

TEST(RequestGuard, CrossSiteFetchWithoutOriginIsRefused) {
    for (const std::string site : {"cross-site", "same-site"}) {
        PanelRequest request = post_request();
        request.origin = "";
        request.fetch_site = site;
        EXPECT_EQ(status(request), 403) << site;
    }
}

TEST(RequestGuard, FormOfAForeignPageIsRefusedByItsContentType) {
    for (const std::string type : {"", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data",
                                   "text/plain; application/json"}) {
        PanelRequest request = post_request();
        request.content_type = type;
        EXPECT_EQ(status(request), 415) << type;
    }
}

TEST(RequestGuard, LongestBodyIsAccepted_AndOneByteMoreIsRefused) {
    PanelRequest request = post_request();
    request.body = std::string(4096, ' ');
    EXPECT_EQ(status(request), 0);
    request.body += ' ';
    EXPECT_EQ(status(request), 413);
}

TEST(RequestGuard, MethodsThatThePanelDoesNotServeAreRefused) {
    for (const std::string method : {"PUT", "DELETE", "PATCH", "OPTIONS", "TRACE"}) {
        PanelRequest request = post_request();
        request.method = method;
        EXPECT_EQ(status(request), 405) << method;
    }
}

TEST(RequestGuard, ErrorTextStaysJsonDespiteQuotesAndInvalidBytes) {
    EXPECT_EQ(error_response(404, "no \"x\"").body, R"({"error":"no \"x\""})");
    EXPECT_NE(error_response(404, "\xFF").body.find("error"), std::string::npos);
}

}  // namespace canproof::host::test
