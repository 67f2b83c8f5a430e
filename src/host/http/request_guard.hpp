// SPDX-License-Identifier: Apache-2.0
// Decides who may access the panel: the panel's own page, and programs on this machine. A page of another site may not
// access it, even if the name of that site resolves to this machine (DNS rebinding).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace canproof::host {

/// The parts of a request that the panel uses.
struct PanelRequest {
    std::string method{"GET"};
    std::string path{"/"};
    std::string host;          ///< value of the header Host
    std::string origin;        ///< value of the header Origin; empty when absent
    std::string fetch_site;    ///< value of the header Sec-Fetch-Site
    std::string content_type;  ///< value of the header Content-Type
    std::string body;
    std::uint64_t changes_from{0};
    std::uint64_t frames_from{0};
};

struct PanelResponse {
    int status{200};
    std::string type{"application/json"};
    std::string body;
    std::string allow{};  ///< value of the header Allow: the methods of a path that does not have the request's method
};

/// Greatest number of bytes in the body of a request.
constexpr std::size_t longest_body = 4096;

/// Returns the response that refuses a request because of its host, method, origin or content; nothing when the request
/// may be answered. Every request needs a Host that names this machine. Its method must be GET, HEAD or POST. A POST
/// can change something; it must also meet these conditions:
/// - an Origin, if there is one, is `http://` and the value of Host;
/// - Sec-Fetch-Site, if there is one, is `same-origin` or `none`;
/// - the content type is JSON, which a page of another site cannot send without permission;
/// - the body has at most longest_body bytes.
std::optional<PanelResponse> refuse(const PanelRequest& request);

/// Returns the response 405 to a request with another method than `allow` lists.
PanelResponse wrong_method(const std::string& allow);

/// Returns a response with the body `{"error": …}`.
PanelResponse error_response(int status, const std::string& text);

}  // namespace canproof::host
