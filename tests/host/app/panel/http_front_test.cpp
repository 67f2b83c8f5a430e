// SPDX-License-Identifier: Apache-2.0
// Tests the panel over a real loopback socket, with clients that are served, slow or refused. The test advances the
// time itself; turn_until() waits for the sockets.
#include "host/app/panel/http_front.hpp"

#include <gmock/gmock.h>
#include <poll.h>

#include <memory>

#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"
#include "tests/host/app/panel/panel_bench.hpp"
#include "tests/support/tcp_client.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::TcpClient;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr int look_again_ms = 10;
constexpr int most_looks = 12000;  // reached only when the expected event never happens

template <typename Condition>
bool turn_until(HttpFront& front, Instant now, const Condition& done) {
    for (int looks = 0; looks < most_looks;) {
        front.turn(now);
        if (done()) {
            return true;
        }
        std::vector<pollfd> waiting;
        for (const Watch& watch : front.watches()) {
            waiting.push_back({watch.descriptor, static_cast<short>(watch.writable ? POLLOUT : POLLIN), 0});
        }
        looks += ::poll(waiting.data(), waiting.size(), look_again_ms) > 0 ? 0 : 1;
    }
    return false;
}

class HttpFrontEnd : public testing::Test {
  protected:
    bool until(const std::function<bool()>& done) { return turn_until(front, now, done); }
    std::string exchange(const std::string& request) {
        TcpClient visitor{front.port()};
        visitor.say(request);
        EXPECT_TRUE(until([&] { return visitor.ended(); }));
        return visitor.heard();
    }
    /// Returns clients that have begun a request and do not continue.
    std::vector<std::unique_ptr<TcpClient>> slow_ones(std::size_t count) {
        std::vector<std::unique_ptr<TcpClient>> all;
        for (std::size_t i = 0; i < count; ++i) {
            all.push_back(std::make_unique<TcpClient>(front.port()));
            all.back()->say("GET /");
            const std::size_t expected = std::min(i + 1, HttpFront::most_connections);
            EXPECT_TRUE(until([&] { return front.connections() == expected; }));
        }
        return all;
    }

    Instant now{1000000};
    PanelResponse answer{200, "text/plain", "hello"};
    int asked{0};
    HttpFront front{[this](const PanelRequest&) {
                        ++asked;
                        return answer;
                    },
                    0};
};

const std::string plain_get = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";

class PanelOverHttp : public testing::Test {
  protected:
    std::string exchange(const std::string& request) {
        TcpClient visitor{front.port()};
        visitor.say(request);
        EXPECT_TRUE(turn_until(front, Instant{}, [&] { return visitor.ended(); }));
        return visitor.heard();
    }
    std::string get(const std::string& path, const std::string& headers = "Host: localhost\r\n") {
        return exchange("GET " + path + " HTTP/1.1\r\n" + headers + "\r\n");
    }
    std::string post(const std::string& body, const std::string& headers, const std::string& method = "POST") {
        return exchange(method + " /api/frame HTTP/1.1\r\nHost: " + host() + "\r\n" + headers +
                        "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
    }
    std::string host() const { return "127.0.0.1:" + std::to_string(front.port()); }
    std::string own_page() const { return "Origin: http://" + host() + "\r\nContent-Type: application/json\r\n"; }

    PanelBench bench{{"cbx-ao412@3"}};
    HttpFront front{[this](const PanelRequest& request) { return bench.panel.answer(request); }, 0};
};

const std::string frame = R"({"frame":"000#0103"})";

}  // namespace

TEST_F(HttpFrontEnd, SlowClientsDoNotDelayOtherClients) {
    const auto slow = slow_ones(HttpFront::most_connections - 1);
    EXPECT_THAT(exchange(plain_get), EndsWith("\r\n\r\nhello"));
}

TEST_F(HttpFrontEnd, ConnectionAboveTheLimitClosesTheOldestConnection_AndIsServed) {
    const auto slow = slow_ones(2 * HttpFront::most_connections);
    EXPECT_EQ(front.connections(), HttpFront::most_connections);
    EXPECT_TRUE(slow.front()->ended());  // the server has closed the oldest connection
    EXPECT_FALSE(slow.back()->ended());
    EXPECT_THAT(exchange(plain_get), EndsWith("\r\n\r\nhello"));
}

TEST_F(HttpFrontEnd, SlowRequestEndsAtItsDeadline) {
    TcpClient drip{front.port()};
    ASSERT_TRUE(until([&] { return front.connections() == 1; }));
    EXPECT_EQ(front.next_deadline(), now + HttpFront::request_limit);
    const Instant end = now + HttpFront::request_limit;
    for (; now < end; now = now + milliseconds(100)) {
        front.turn(now);
        ASSERT_EQ(front.connections(), 1U);
        drip.say("X");
    }
    front.turn(now);
    EXPECT_EQ(front.connections(), 0U);
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(front.next_deadline(), never);
}

TEST_F(HttpFrontEnd, ClientThatDoesNotReadIsDisconnectedAtItsDeadline) {
    // a response longer than the buffers of the kernel, so that it cannot be sent at once
    answer.body = std::string(32U * 1024U * 1024U, 'x');
    const TcpClient deaf{front.port()};
    deaf.say(plain_get);
    ASSERT_TRUE(until([&] { return asked == 1; }));
    now = now + Duration{HttpFront::response_limit.us - 1};
    front.turn(now);
    EXPECT_EQ(front.connections(), 1U);
    now = now + microseconds(1);
    front.turn(now);
    EXPECT_EQ(front.connections(), 0U);
}

TEST_F(HttpFrontEnd, ClientThatNeverClosesItsConnectionIsDisconnectedAtTheDeadline) {
    TcpClient stays{front.port()};
    stays.say(plain_get);
    // the client has received the whole response, but does not close the connection
    ASSERT_TRUE(until([&] { return stays.ended(); }));
    EXPECT_THAT(stays.heard(), EndsWith("hello"));
    EXPECT_EQ(front.connections(), 1U);
    now = now + HttpFront::close_limit;
    front.turn(now);
    EXPECT_EQ(front.connections(), 0U);
}

TEST_F(HttpFrontEnd, LongResponseArrivesCompletely) {
    answer.body = std::string(3U * 1024U * 1024U, 'x');
    EXPECT_THAT(exchange(plain_get), EndsWith("\r\n\r\n" + answer.body));
}

TEST_F(HttpFrontEnd, RefusalArrivesBeforeTheRequestIsComplete) {
    const std::string heard = exchange("GET /" + std::string(100000, 'a'));
    EXPECT_THAT(heard, StartsWith("HTTP/1.1 414 "));
    EXPECT_THAT(heard, HasSubstr("2048 bytes"));
    EXPECT_EQ(asked, 0);
}

TEST_F(HttpFrontEnd, RangeHeadersAreIgnored) {
    std::string ranges = "Range: bytes=0-";
    while (ranges.size() < 7900) {
        ranges += ",0-";
    }
    for (const std::string method : {"GET", "HEAD"}) {
        const std::string whole = exchange(method + " / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        EXPECT_EQ(exchange(method + " / HTTP/1.1\r\nHost: localhost\r\n" + ranges + "\r\n\r\n"), whole);
        EXPECT_THAT(whole, StartsWith("HTTP/1.1 200 OK\r\n"));
        EXPECT_THAT(whole, HasSubstr("Content-Length: 5\r\n"));
        EXPECT_THAT(whole, EndsWith(method == "GET" ? "\r\n\r\nhello" : "\r\n\r\n"));
    }
}

TEST(FrontThatEnds, ServerEndsWithoutWaitingForItsClients) {
    auto front = std::make_unique<HttpFront>([](const PanelRequest&) { return PanelResponse{}; }, std::uint16_t{0});
    TcpClient slow{front->port()};
    slow.say("GET /");
    ASSERT_TRUE(turn_until(*front, Instant{}, [&] { return front->connections() == 1; }));
    front.reset();
    int looks = 0;
    while (!slow.ended() && ++looks < most_looks) {
        slow.wait(look_again_ms);
    }
    EXPECT_TRUE(slow.ended());
}

TEST_F(PanelOverHttp, PageIsServedWithItsContentSecurityPolicy) {
    const std::string page = get("/");
    EXPECT_THAT(page, StartsWith("HTTP/1.1 200 OK\r\n"));
    EXPECT_THAT(page, HasSubstr("\r\nContent-Security-Policy: default-src 'none'; script-src 'self';"));
    EXPECT_THAT(page, HasSubstr("\r\nContent-Type: text/html"));
    EXPECT_THAT(page, HasSubstr("\r\nCross-Origin-Resource-Policy: same-origin\r\n"));
    EXPECT_THAT(page, HasSubstr("\r\nConnection: close\r\n"));
    EXPECT_THAT(page, Not(HasSubstr("Access-Control-Allow-Origin")));
    EXPECT_THAT(get("/nothing"), StartsWith("HTTP/1.1 404 "));
}

TEST_F(PanelOverHttp, PageIsSentOnceForARequestOfThousandsOfRanges) {
    std::string ranges = "Host: localhost\r\nRange: bytes=0-";
    while (ranges.size() < 7900) {
        ranges += ",0-";
    }
    EXPECT_EQ(get("/", ranges + "\r\n"), get("/"));
}

TEST_F(PanelOverHttp, FrameSentFromThePanelPageReachesTheBus) {
    EXPECT_THAT(post(frame, own_page()), StartsWith("HTTP/1.1 200 "));
    bench.run_until(100);
    const std::string state = get("/api/state?changes=0&frames=0");
    EXPECT_THAT(state, HasSubstr("operational"));
    EXPECT_THAT(state, Not(HasSubstr("pre-operational")));
}

TEST_F(PanelOverHttp, RefusalHasTheReasonPhraseOfItsStatus) {
    // the phrases of RFC 9110, section 15, and of RFC 6585, section 5
    EXPECT_THAT(get("/nothing"), StartsWith("HTTP/1.1 404 Not Found\r\n"));
    EXPECT_THAT(post(frame, own_page(), "PUT"), StartsWith("HTTP/1.1 405 Method Not Allowed\r\n"));
    EXPECT_THAT(post(frame, "Content-Type: text/plain\r\n"), StartsWith("HTTP/1.1 415 Unsupported Media Type\r\n"));
    EXPECT_THAT(get("/", "Host: localhost\r\nExpect: 100-continue\r\n"),
                StartsWith("HTTP/1.1 417 Expectation Failed\r\n"));
    EXPECT_THAT(get("/", "Host: localhost\r\nTransfer-Encoding: chunked\r\n"),
                StartsWith("HTTP/1.1 411 Length Required\r\n"));
    EXPECT_THAT(get("/", "Host: localhost\r\nContent-Length: 4097\r\n"),
                StartsWith("HTTP/1.1 413 Content Too Large\r\n"));
    EXPECT_THAT(get("/" + std::string(3000, 'a')), StartsWith("HTTP/1.1 414 URI Too Long\r\n"));
}

TEST_F(PanelOverHttp, WrongMethodOfAPathNamesTheMethodsOfThisPath) {
    EXPECT_THAT(get("/api/frame"), StartsWith("HTTP/1.1 405 "));
    EXPECT_THAT(get("/api/frame"), HasSubstr("\r\nAllow: POST\r\n"));
    EXPECT_THAT(post(frame, own_page(), "PUT"), HasSubstr("\r\nAllow: POST\r\n"));
    EXPECT_THAT(get("/"), Not(HasSubstr("\r\nAllow: ")));
}

TEST_F(PanelOverHttp, RequestWithForeignOriginHostContentTypeOrMethodIsRefused) {
    EXPECT_THAT(post(frame, "Origin: http://evil.example\r\nContent-Type: application/json\r\n"),
                StartsWith("HTTP/1.1 403 "));
    EXPECT_THAT(post(frame, "Content-Type: text/plain\r\n"), StartsWith("HTTP/1.1 415 "));
    EXPECT_THAT(get("/api/state", "Host: evil.example\r\n"), StartsWith("HTTP/1.1 403 "));
    EXPECT_THAT(get("/api/state", ""), StartsWith("HTTP/1.1 403 "));
    EXPECT_THAT(post(frame, own_page(), "PUT"), StartsWith("HTTP/1.1 405 "));
    bench.run_until(100);
    EXPECT_THAT(bench.log.str(), Not(HasSubstr("000#0103")));
}

TEST_F(PanelOverHttp, OversizedBodyIsRefused_WithContentLengthOrChunked) {
    const std::string long_body(5000, ' ');
    EXPECT_THAT(post(long_body, own_page()), StartsWith("HTTP/1.1 413 "));
    // The body is chunked; 1388h is 5000.
    EXPECT_THAT(exchange("POST /api/frame HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                         "Transfer-Encoding: chunked\r\n\r\n1388\r\n" +
                         long_body + "\r\n0\r\n\r\n"),
                StartsWith("HTTP/1.1 411 "));
    EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 200 "));
}

TEST_F(PanelOverHttp, RequestHiddenInTheBodyOfARefusedRequestIsNotExecuted) {
    const std::string hidden =
        "POST /api/frame HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
        "20\r\n\r\n{\"frame\":\"000#0103\"}";
    EXPECT_THAT(exchange("POST /api/frame HTTP/1.1\r\nHost: evil.example\r\nOrigin: http://evil.example\r\n"
                         "Content-Type: text/plain\r\nContent-Length: 0\r\n\r\n" +
                         hidden),
                StartsWith("HTTP/1.1 403 "));
    bench.run_until(100);
    EXPECT_THAT(bench.log.str(), Not(HasSubstr("000#0103")));
}

TEST_F(PanelOverHttp, InvalidHttpIsRefusedAndTheNextRequestIsServed) {
    EXPECT_THAT(exchange("\x01\x02\x03\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
    EXPECT_THAT(get("/"), StartsWith("HTTP/1.1 200 "));
}

TEST_F(PanelOverHttp, PortInUseIsRefusedWithTheRemedy) {
    try {
        const HttpFront second{[](const PanelRequest&) { return PanelResponse{}; }, front.port()};
        FAIL() << "two panels on one port";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("(Address already in use); name another port with --port"));
    }
}

}  // namespace canproof::host::test
