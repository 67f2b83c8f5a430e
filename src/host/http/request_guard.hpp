// SPDX-License-Identifier: Apache-2.0
// Decides who may access the panel: its own page, and programs on this machine. A page of another site may not, even if
// its name was made to resolve to this machine (DNS rebinding).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace canproof::host {

/// The parts of a request that the panel uses.
struct PanelRequest {
    std::string method{"GET"};
    std::string path{"/"};
    std::string host;          ///< header Host
    std::string origin;        ///< header Origin; empty when absent
    std::string fetch_site;    ///< header Sec-Fetch-Site
    std::string content_type;  ///< header Content-Type
    std::string body;
    std::uint64_t changes_from{0};
    std::uint64_t frames_from{0};
};

struct PanelResponse {
    int status{200};
    std::string type{"application/json"};
    std::string body;
};

/// Greatest number of bytes in the body of a request.
constexpr std::size_t longest_body = 4096;

/// Returns the refusal of a request because of its origin or content; nothing when it may be answered. Every request
/// needs a Host that names this machine. A request that changes something also needs: an Origin, if present, equal to
/// the requested host; the content type JSON, which a foreign page cannot send without permission; and a body that is
/// not too long.
std::optional<PanelResponse> refuse(const PanelRequest& request);

/// Returns a response with the body `{"error": …}`.
PanelResponse error_response(int status, const std::string& text);

}  // namespace canproof::host
