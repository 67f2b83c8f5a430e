// The panel over a real loopback socket: limits of requests, headers, ports.
#include "host/panel/panel_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include "host/bus/candump.hpp"
#include "panel_bench.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class PanelOverHttp : public testing::Test {
  protected:
    httplib::Client client() const { return httplib::Client{"127.0.0.1", server_.port()}; }
    httplib::Headers own_page() const { return {{"Origin", "http://127.0.0.1:" + std::to_string(server_.port())}}; }
    /// Bytes out, and everything that comes back until the server closes.
    std::string raw(const std::string& request) const {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(server_.port());
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
        EXPECT_EQ(::send(socket, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
        std::string answer;
        char piece[1024];
        for (ssize_t count = recv(socket, piece, sizeof piece, 0); count > 0;
             count = recv(socket, piece, sizeof piece, 0)) {
            answer.append(piece, static_cast<std::size_t>(count));
        }
        close(socket);
        return answer;
    }

    PanelBench bench_{{"cbx-ao412@3"}};
    PanelServer server_{bench_.panel, 0};
};

}  // namespace

TEST_F(PanelOverHttp, PageIsServedWithItsPolicy) {
    const auto page = client().Get("/");
    ASSERT_TRUE(page);
    EXPECT_EQ(page->status, 200);
    EXPECT_THAT(page->get_header_value("Content-Security-Policy"), HasSubstr("default-src 'none'"));
    EXPECT_THAT(page->get_header_value("Content-Type"), StartsWith("text/html"));
    EXPECT_EQ(page->get_header_value("Cross-Origin-Resource-Policy"), "same-origin");
    EXPECT_EQ(page->get_header_value("Access-Control-Allow-Origin"), "");
    EXPECT_EQ(client().Get("/nothing")->status, 404);
}

TEST_F(PanelOverHttp, FrameFromOwnPageReachesTheBus) {
    const auto answer = client().Post("/api/frame", own_page(), R"({"frame":"000#0103"})", "application/json");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 200);
    bench_.run_until(100);
    const auto state = client().Get("/api/state?changes=0&frames=0");
    EXPECT_THAT(state->body, HasSubstr("operational"));
    EXPECT_THAT(state->body, Not(HasSubstr("pre-operational")));
}

TEST_F(PanelOverHttp, ForeignOriginAndHostAreRefused) {
    const std::string frame = R"({"frame":"000#0103"})";
    EXPECT_EQ(client().Post("/api/frame", {{"Origin", "http://evil.example"}}, frame, "application/json")->status, 403);
    EXPECT_EQ(client().Post("/api/frame", own_page(), frame, "text/plain")->status, 415);
    EXPECT_EQ(client().Get("/api/state", {{"Host", "evil.example"}})->status, 403);
    EXPECT_EQ(client().Put("/api/frame", own_page(), frame, "application/json")->status, 404);
    bench_.run_until(100);
    EXPECT_THAT(bench_.log.str(), Not(HasSubstr("000#0103")));
}

TEST_F(PanelOverHttp, OversizeIsRefused_AnnouncedOrNot) {
    const std::string long_body(5000, ' ');
    const auto announced = client().Post("/api/frame", own_page(), long_body, "application/json");
    ASSERT_TRUE(announced);
    EXPECT_EQ(announced->status, 413);
    // Chunked: 1388h is 5000.
    const std::string chunked =
        raw("POST /api/frame HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nTransfer-Encoding: "
            "chunked\r\n\r\n1388\r\n" +
            long_body + "\r\n0\r\n\r\n");
    EXPECT_THAT(chunked, testing::AnyOf(StartsWith("HTTP/1.1 4"), ""));
    EXPECT_EQ(client().Get("/")->status, 200);
}

TEST_F(PanelOverHttp, RequestHiddenInARefusedOnesBodyIsNeverPlayed) {
    const std::string hidden =
        "POST /api/frame HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: "
        "20\r\n\r\n{\"frame\":\"000#0103\"}";
    const std::string answer =
        raw("POST /api/frame HTTP/1.1\r\nHost: evil.example\r\nOrigin: http://evil.example\r\n"
            "Content-Type: text/plain\r\nContent-Length: 0\r\n\r\n" +
            hidden);
    EXPECT_THAT(answer, testing::AnyOf(StartsWith("HTTP/1.1 403"), ""));
    bench_.run_until(100);
    EXPECT_THAT(bench_.log.str(), Not(HasSubstr("000#0103")));
}

TEST_F(PanelOverHttp, NoHttpAtAllEndsTheConnection) {
    EXPECT_THAT(raw("\x01\x02\x03\r\n\r\n"), testing::AnyOf(StartsWith("HTTP/1.1 400"), ""));
    EXPECT_EQ(client().Get("/")->status, 200);
}

TEST_F(PanelOverHttp, PortThatIsTakenIsRefusedWithTheRemedy) {
    try {
        const PanelServer second{bench_.panel, server_.port()};
        FAIL() << "two panels on one port";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--port"));
    }
}

}  // namespace canproof::host::test
