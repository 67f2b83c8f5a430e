// One request of HTTP/1.1, read a piece at a time in bounded memory. What the panel does not ask for is dropped.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host/http/request_guard.hpp"

namespace canproof::host {

/// Host, Origin, Sec-Fetch-Site and Content-Type are kept, once each; other headers have no effect. A body has a length
/// that is announced: Transfer-Encoding is refused, and so is Expect.
class HttpRequest {
  public:
    static constexpr std::size_t longest_request_line = 2048;
    static constexpr std::size_t longest_header_line = 8192;
    static constexpr std::size_t longest_head = 16384;

    /// What follows the end of the request is passed over.
    void take(std::string_view bytes);
    /// The request is whole, or is refused: nothing more is read.
    bool is_done() const { return refusal_.has_value() || part_ == Part::done; }
    /// What was read; whole when is_done() and there is no refusal.
    const PanelRequest& request() const { return request_; }
    const std::optional<PanelResponse>& refusal() const { return refusal_; }
    /// Bytes that are held.
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
    std::size_t head_{0};  ///< bytes of request line and headers so far
    std::size_t length_{0};
    std::set<std::string> seen_;  ///< of the headers that may stand there once
    PanelRequest request_;
    std::optional<PanelResponse> refusal_;
};

}  // namespace canproof::host
