// SPDX-License-Identifier: Apache-2.0
// Parses one HTTP/1.1 request piece by piece in bounded memory. Discards everything that the panel does not use.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host/http/request_guard.hpp"

namespace canproof::host {

/// Parses a request. Stores the headers Host, Origin, Sec-Fetch-Site and Content-Type. A body needs a Content-Length.
/// Each of these five headers may occur once. Refuses Transfer-Encoding and Expect; all other headers have no effect.
class HttpRequest {
  public:
    static constexpr std::size_t longest_request_line = 2048;
    static constexpr std::size_t longest_header_line = 8192;
    static constexpr std::size_t longest_head = 16384;

    /// Parses further bytes. Discards bytes after the end of the request.
    void take(std::string_view bytes);
    /// Returns whether the request is complete or refused; further bytes are then discarded.
    bool is_done() const { return refusal_.has_value() || part_ == Part::done; }
    /// Returns the parsed request. It is complete when is_done() returns true and there is no refusal.
    const PanelRequest& request() const { return request_; }
    const std::optional<PanelResponse>& refusal() const { return refusal_; }
    /// Returns how many bytes of the current line and of the body are buffered.
    std::size_t held() const { return line_.size() + request_.body.size(); }

  private:
    enum class Part { request_line, headers, body, done };

    void take_character(char one);
    void end_line();
    void read_request_line();
    void read_header();
    void keep_header(const std::string& name, const std::string& value);
    void read_length(const std::string& value);
    void refuse_with(int status, const std::string& why);

    Part part_{Part::request_line};
    std::string line_;
    std::size_t head_{0};  ///< number of bytes of the request line and the headers so far
    std::size_t length_{0};
    std::set<std::string> seen_;  ///< headers that have occurred and may not occur again
    PanelRequest request_;
    std::optional<PanelResponse> refusal_;
};

}  // namespace canproof::host
