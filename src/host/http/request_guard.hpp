// Who may talk to the panel: its own page, and programs on this machine. A page of another site may not, even where its
// name was made to point here (DNS rebinding).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace canproof::host {

/// A request as far as the panel looks at it.
struct PanelRequest {
    std::string method{"GET"};
    std::string path{"/"};
    std::string host;          ///< header Host
    std::string origin;        ///< header Origin; empty where there is none
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

/// The most bytes that a request may carry.
constexpr std::size_t longest_body = 4096;

/// The refusal that a request gets for where it comes from or what it carries; nothing when it may be answered.
/// Every request: a Host that is this machine by name or number. One that changes something: an Origin, where there is
/// one, that is the host asked for; JSON, which a foreign page cannot send without being asked for leave; its length.
std::optional<PanelResponse> refuse(const PanelRequest& request);

/// `{"error": …}`
PanelResponse error_response(int status, const std::string& text);

}  // namespace canproof::host
