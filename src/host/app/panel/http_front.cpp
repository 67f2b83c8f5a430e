// SPDX-License-Identifier: Apache-2.0
#include "host/app/panel/http_front.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"

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
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        default:
            return status >= 500 ? "Server Error" : "Bad Request";
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
               "Content-Type: {}\r\n"
               "Content-Length: {}\r\n\r\n",
               response.status, reason(response.status), response.type, response.body.size()) +
           (with_body ? response.body : "");
}

/// Closes the socket, unless it is -1, and throws InputError with the reason in errno.
[[noreturn]] void refuse_port(int descriptor, std::uint16_t port) {
    const std::string reason = std::generic_category().message(errno);
    if (descriptor >= 0) {
        close(descriptor);
    }
    throw InputError{
        fmt::format("port {} of {} cannot be opened: {}; name another port with --port, or 0 for any free port", port,
                    loopback, reason)};
}

/// Returns a socket that listens at this port of the loopback address; port 0 selects a free one. Throws InputError
/// when the port cannot be opened.
int listen_at(std::uint16_t port) {
    const int descriptor = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int on = 1;
    const bool listens = descriptor >= 0 && setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
                         bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                         listen(descriptor, waiting_connections) == 0;
    if (!listens) {
        refuse_port(descriptor, port);
    }
    return descriptor;
}

/// Returns the port of a listening socket. Closes the socket and throws InputError when the system does not report it.
std::uint16_t port_of(int descriptor, std::uint16_t asked) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
        refuse_port(descriptor, asked);
    }
    return ntohs(address.sin_port);
}

bool must_wait() {
    return errno == EAGAIN || errno == EINTR;
}

}  // namespace

HttpFront::HttpFront(Answer answer, std::uint16_t port)
    : answer_{std::move(answer)}, listener_{listen_at(port)}, port_{port_of(listener_, port)} {}

HttpFront::~HttpFront() {
    for (const auto& one : connections_) {
        close(one->descriptor);
    }
    close(listener_);
}

std::string HttpFront::address() const {
    return fmt::format("http://{}:{}/", loopback, port_);
}

std::vector<Watch> HttpFront::watches() const {
    std::vector<Watch> all{{listener_, true, false}};
    for (const auto& one : connections_) {
        const bool writes = one->answered && !one->closing;
        all.push_back({one->descriptor, !writes, writes});
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
        const int descriptor = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (descriptor < 0) {
            return;
        }
        const int on = 1;
        // if this fails, responses are only slower
        static_cast<void>(setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on));
        if (connections_.size() == most_connections) {
            make_place();
        }
        connections_.push_back(std::make_unique<Connection>());
        connections_.back()->descriptor = descriptor;
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
    const ssize_t count = recv(one.descriptor, piece.data(), piece.size(), 0);
    if (count > 0) {
        one.request.take({piece.data(), static_cast<std::size_t>(count)});
    } else {
        one.gone = one.gone || count == 0 || !must_wait();
    }
}

void HttpFront::write_some(Connection& one, Instant now) {
    const ssize_t count =
        send(one.descriptor, one.output.data() + one.written, one.output.size() - one.written, MSG_NOSIGNAL);
    one.gone = one.gone || (count < 0 && !must_wait());
    one.written += count > 0 ? static_cast<std::size_t>(count) : 0U;
    if (one.written == one.output.size()) {
        // an immediate close could cut off a response that the client has not read yet
        shutdown(one.descriptor, SHUT_WR);
        one.closing = true;
        one.deadline = now + close_limit;
        one.output = {};
    }
}

void HttpFront::drop_gone() {
    for (const auto& one : connections_) {
        if (one->gone) {
            close(one->descriptor);
        }
    }
    connections_.erase(
        std::remove_if(connections_.begin(), connections_.end(), [](const auto& one) { return one->gone; }),
        connections_.end());
}

}  // namespace canproof::host
