// SPDX-License-Identifier: Apache-2.0
#include "host/http/request_guard.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace canproof::host {

namespace {

/// Returns the host without its port: `[::1]` for `[::1]:8404`.
std::string without_port(const std::string& host) {
    const auto colon = host.rfind(':');
    const bool in_brackets = host.find(']') != std::string::npos && host.find(']') > colon;
    const bool has_port = colon != std::string::npos && !in_brackets && colon + 1 < host.size() &&
                          host.find_first_not_of("0123456789", colon + 1) == std::string::npos;
    return has_port ? host.substr(0, colon) : host;
}

bool is_this_machine(const std::string& host) {
    const std::string name = without_port(host);
    return name == "127.0.0.1" || name == "localhost" || name == "[::1]";
}

bool is_json(const std::string& type) {
    return type.substr(0, type.find(';')) == "application/json";
}

}  // namespace

PanelResponse error_response(int status, const std::string& text) {
    // The text can contain invalid UTF-8 from the request. It is replaced, so that it causes no exception.
    const nlohmann::json body{{"error", text}};
    return {status, "application/json", body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

PanelResponse wrong_method(const std::string& allow) {
    PanelResponse response = error_response(405, "this method is not allowed here; use " + allow);
    response.allow = allow;
    return response;
}

std::optional<PanelResponse> refuse(const PanelRequest& request) {
    if (!is_this_machine(request.host)) {
        return error_response(
            403, "the panel answers requests to 127.0.0.1, localhost and [::1] only; open it under one of these names");
    }
    if (request.method == "GET" || request.method == "HEAD") {
        return std::nullopt;
    }
    if (request.method != "POST") {
        return wrong_method("GET, HEAD, POST");
    }
    if (!request.origin.empty() && request.origin != "http://" + request.host) {
        return error_response(
            403, "the request comes from a page of another site; only the panel's own page may change something");
    }
    if (!request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none") {
        return error_response(
            403, "the request comes from a page of another site; only the panel's own page may change something");
    }
    if (!is_json(request.content_type)) {
        return error_response(415, "the body is not of the type application/json; send JSON");
    }
    if (request.body.size() > longest_body) {
        return error_response(
            413, fmt::format("the body of a request may have at most {} bytes; send a shorter body", longest_body));
    }
    return std::nullopt;
}

}  // namespace canproof::host
