// SPDX-License-Identifier: Apache-2.0
#include "host/app/panel/http_front.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <utility>

#include "firmware/base/time.hpp"

namespace canproof::host {

namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr int waiting_connections = 64;
constexpr int accepted_at_once = 32;
constexpr std::size_t piece_size = 16384;

const char* reason(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 400:
            return "Bad Request";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 411:
            return "Length Required";
        case 413:
            return "Content Too Large";
        case 414:
            return "URI Too Long";
        case 415:
            return "Unsupported Media Type";
        case 417:
            return "Expectation Failed";
        case 422:
            return "Unprocessable Content";
        case 431:
            return "Request Header Fields Too Large";
        case 503:
            return "Service Unavailable";
        case 505:
            return "HTTP Version Not Supported";
        default:
            return status >= 500 ? "Internal Server Error" : "Bad Request";
    }
}

/// Returns the response text. Its headers forbid content of other sites, display inside another page, and caching. They
/// also announce that the connection closes after one request.
std::string response_text(const PanelResponse& response, bool with_body) {
    return fmt::format(
               "HTTP/1.1 {} {}\r\n"
               "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' "
               "data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
               "X-Content-Type-Options: nosniff\r\n"
               "Cross-Origin-Resource-Policy: same-origin\r\n"
               "Referrer-Policy: no-referrer\r\n"
               "Cache-Control: no-store\r\n"
               "Connection: close\r\n"
               "{}Content-Type: {}\r\n"
               "Content-Length: {}\r\n\r\n",
               response.status, reason(response.status),
               response.allow.empty() ? "" : "Allow: " + response.allow + "\r\n", response.type, response.body.size()) +
           (with_body ? response.body : "");
}

bool must_wait() {
    return errno == EAGAIN || errno == EINTR;
}

}  // namespace

HttpFront::HttpFront(Answer answer, std::uint16_t port)
    : answer_{std::move(answer)},
      listener_{
          listen_at(loopback, port, waiting_connections, "name another port with --port, or 0 for any free port")} {}

std::string HttpFront::address() const {
    return fmt::format("http://{}:{}/", loopback, port());
}

std::vector<Watch> HttpFront::watches() const {
    std::vector<Watch> all{{listener_.socket.number(), true, false}};
    for (const auto& one : connections_) {
        const bool writes = one->answered && !one->closing;
        all.push_back({one->socket.number(), !writes, writes});
    }
    return all;
}

Instant HttpFront::next_deadline() const {
    Instant next = never;
    for (const auto& one : connections_) {
        next = earliest(next, one->deadline);
    }
    return next;
}

void HttpFront::turn(Instant now) {
    accept_clients(now);
    for (const auto& one : connections_) {
        serve(*one, now);
        one->gone = one->gone || one->deadline <= now;
    }
    drop_gone();
}

void HttpFront::accept_clients(Instant now) {
    for (int i = 0; i < accepted_at_once; ++i) {
        Descriptor client = accept_client(listener_.socket);
        if (!client.is_open()) {
            return;
        }
        if (connections_.size() == most_connections) {
            make_place();
        }
        connections_.push_back(std::make_unique<Connection>());
        connections_.back()->socket = std::move(client);
        connections_.back()->deadline = now + request_limit;
        // serves the client now, because a later client can displace it
        serve(*connections_.back(), now);
    }
}

/// Closes the connection with the earliest deadline, to make room for another client. If the response of some
/// connections is already sent, considers only these.
void HttpFront::make_place() {
    const auto rank = [](const auto& one) { return std::pair{!one->closing, one->deadline.us}; };
    const auto first = std::min_element(connections_.begin(), connections_.end(),
                                        [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    (*first)->gone = true;
    drop_gone();
}

void HttpFront::serve(Connection& one, Instant now) {
    if (!one.answered) {
        read_some(one);
        if (one.request.is_done()) {
            const PanelResponse response =
                one.request.refusal() ? *one.request.refusal() : answer_(one.request.request());
            one.output = response_text(response, one.request.request().method != "HEAD");
            one.answered = true;
            one.deadline = now + response_limit;
        }
    }
    if (one.answered && !one.closing) {
        write_some(one, now);
    } else if (one.closing) {
        read_some(one);
    }
}

void HttpFront::read_some(Connection& one) {
    std::array<char, piece_size> piece{};
    const ssize_t count = recv(one.socket.number(), piece.data(), piece.size(), 0);
    if (count > 0) {
        one.request.take({piece.data(), static_cast<std::size_t>(count)});
    } else {
        one.gone = one.gone || count == 0 || !must_wait();
    }
}

void HttpFront::write_some(Connection& one, Instant now) {
    const auto count = send_some(one.socket, std::string_view{one.output}.substr(one.written));
    one.gone = one.gone || !count;
    one.written += count.value_or(0);
    if (one.written == one.output.size()) {
        // an immediate close could cut off a response that the client has not read yet
        shutdown(one.socket.number(), SHUT_WR);
        one.closing = true;
        one.deadline = now + close_limit;
        one.output = {};
    }
}

void HttpFront::drop_gone() {
    connections_.erase(
        std::remove_if(connections_.begin(), connections_.end(), [](const auto& one) { return one->gone; }),
        connections_.end());
}

}  // namespace canproof::host
