#include "host/panel/panel_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <charconv>
#include <thread>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr std::size_t worker_threads = 8;
constexpr std::chrono::seconds patience{2};  // with a client that sends or reads slowly

std::uint64_t number_parameter(const httplib::Request& request, const char* name) {
    const std::string text = request.get_param_value(name);
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

PanelRequest request_of(const httplib::Request& from) {
    PanelRequest request;
    request.method = from.method;
    request.path = from.path;
    request.host = from.get_header_value("Host");
    request.origin = from.get_header_value("Origin");
    request.fetch_site = from.get_header_value("Sec-Fetch-Site");
    request.content_type = from.get_header_value("Content-Type");
    request.changes_from = number_parameter(from, "changes");
    request.frames_from = number_parameter(from, "frames");
    return request;
}

/// The body as far as it is allowed to be long, and one byte more: the guard then sees that it is too long. A chunked
/// body announces no length, so that the server's own limit would not hold it.
std::string read_body(const httplib::ContentReader& reader) {
    std::string body;
    const bool whole = reader([&](const char* bytes, std::size_t count) {
        body.append(bytes, std::min(count, longest_body + 1U - body.size()));
        return body.size() <= longest_body;
    });
    if (!whole) {
        body.resize(longest_body + 1U);  // refused by its announced length, or while it came
    }
    return body;
}

void put(const PanelResponse& answer, httplib::Response& response) {
    response.status = answer.status;
    response.set_content(answer.body, answer.type.c_str());
}

/// Nothing is loaded from elsewhere, nothing may frame the page, nothing is kept.
httplib::Headers page_headers() {
    return {{"Content-Security-Policy",
             "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
             "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
            {"X-Content-Type-Options", "nosniff"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Referrer-Policy", "no-referrer"},
            {"Cache-Control", "no-store"}};
}

/// Without SO_REUSEPORT, which httplib would set: two panels must not share a port unnoticed.
void reuse_address_only(socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

struct PanelServer::Listener {
    httplib::Server server;
    std::thread thread;
};

PanelServer::PanelServer(Panel& panel, std::uint16_t port) : listener_{std::make_unique<Listener>()} {
    httplib::Server& server = listener_->server;
    server.new_task_queue = [] { return new httplib::ThreadPool{worker_threads}; };
    server.set_socket_options(reuse_address_only);
    server.set_tcp_nodelay(true);
    // One request a connection: what a refused request leaves unread is never taken for the next one.
    server.set_keep_alive_max_count(1);
    server.set_read_timeout(patience);
    server.set_write_timeout(patience);
    server.set_payload_max_length(longest_body);
    server.set_default_headers(page_headers());
    server.Get(".*", [&panel](const httplib::Request& request, httplib::Response& response) {
        put(panel.answer(request_of(request)), response);
    });
    server.Post(".*", [&panel](const httplib::Request& request, httplib::Response& response,
                               const httplib::ContentReader& reader) {
        PanelRequest one = request_of(request);
        one.body = read_body(reader);
        put(panel.answer(one), response);
    });
    // Other methods, and what the server itself refuses.
    server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
        if (response.body.empty()) {
            put(error_response(response.status, fmt::format("refused with status {}", response.status)), response);
        }
    });
    if (port == 0) {
        const int any = server.bind_to_any_port(loopback);
        port_ = any > 0 ? static_cast<std::uint16_t>(any) : std::uint16_t{0};
    } else if (server.bind_to_port(loopback, port)) {
        port_ = port;
    }
    if (port_ == 0) {
        throw InputError{fmt::format("port {} of {} cannot be had; name another with --port, or 0 for any that is free",
                                     port, loopback)};
    }
    listener_->thread = std::thread{[&server] { server.listen_after_bind(); }};
    while (!server.is_running()) {
        std::this_thread::yield();  // stop() before this would be lost
    }
}

PanelServer::~PanelServer() {
    listener_->server.stop();
    listener_->thread.join();
}

std::string PanelServer::address() const {
    return fmt::format("http://{}:{}/", loopback, port_);
}

}  // namespace canproof::host
