// SPDX-License-Identifier: Apache-2.0
#include "host/http/http_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "host/base/trimmed.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t longest_number = 9;  // greatest number of digits of a Content-Length

bool is_digit(char one) {
    return one >= '0' && one <= '9';
}

/// Returns whether a character may be part of a header's name (RFC 9110, 5.6.2).
bool is_token(char one) {
    const bool letter = (one >= 'a' && one <= 'z') || (one >= 'A' && one <= 'Z');
    return letter || is_digit(one) || std::string_view{"!#$%&'*+-.^_`|~"}.find(one) != std::string_view::npos;
}

bool is_shown(char one) {
    return one > ' ' && one < '\x7F';
}

bool is_control(char one) {
    return (static_cast<unsigned char>(one) < 0x20U && one != '\t') || one == '\x7F';
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char one) { return one >= 'A' && one <= 'Z' ? static_cast<char>(one - 'A' + 'a') : one; });
    return text;
}

/// Returns the number of a name in a query: 12 for `name=12`. Returns 0 when the name is missing or no digits follow
/// it.
std::uint64_t number_in(const std::string& query, const std::string& name) {
    std::uint64_t number = 0;
    for (std::size_t begin = 0; begin < query.size();) {
        const std::size_t end = std::min(query.find('&', begin), query.size());
        if (query.compare(begin, name.size() + 1, name + "=") == 0) {
            std::from_chars(query.data() + begin + name.size() + 1, query.data() + end, number);
        }
        begin = end + 1;
    }
    return number;
}

}  // namespace

void HttpRequest::take(std::string_view bytes) {
    while (!bytes.empty() && !is_done()) {
        if (part_ == Part::body) {
            const std::size_t count = std::min(length_ - request_.body.size(), bytes.size());
            request_.body.append(bytes.substr(0, count));
            bytes.remove_prefix(count);
            part_ = request_.body.size() == length_ ? Part::done : Part::body;
        } else {
            take_character(bytes.front());
            bytes.remove_prefix(1);
        }
    }
}

void HttpRequest::take_character(char one) {
    ++head_;
    const bool request_line = part_ == Part::request_line;
    const std::size_t longest = request_line ? longest_request_line : longest_header_line;
    if (one == '\n') {
        end_line();
    } else if (line_.size() > longest || (line_.size() == longest && one != '\r')) {
        refuse_with(request_line ? 414 : 431,
                    fmt::format("a line of the request may have at most {} bytes; send a shorter line", longest));
    } else {
        line_ += one;
    }
    if (head_ >= longest_head && (part_ == Part::request_line || part_ == Part::headers)) {
        refuse_with(431, fmt::format("request line and headers together may have at most {} bytes; send fewer headers",
                                     longest_head));
    }
}

void HttpRequest::end_line() {
    if (!line_.empty() && line_.back() == '\r') {
        line_.pop_back();
    }
    if (std::any_of(line_.begin(), line_.end(), is_control)) {
        refuse_with(400, "a line of the request contains control characters; send printable characters only");
    } else if (part_ == Part::request_line) {
        read_request_line();
    } else {
        read_header();
    }
    line_.clear();
}

void HttpRequest::read_request_line() {
    const auto first = line_.find(' ');
    const auto second = first == std::string::npos ? first : line_.find(' ', first + 1);
    if (second == std::string::npos || line_.find(' ', second + 1) != std::string::npos) {
        return refuse_with(400, "the first line of the request is not of the form `METHOD /PATH HTTP/1.1`");
    }
    const std::string version = line_.substr(second + 1);
    const std::string target = line_.substr(first + 1, second - first - 1);
    request_.method = line_.substr(0, first);
    const bool method = !request_.method.empty() && std::all_of(request_.method.begin(), request_.method.end(),
                                                                [](char one) { return one >= 'A' && one <= 'Z'; });
    if (!method || target.empty() || target.front() != '/' || !std::all_of(target.begin(), target.end(), is_shown)) {
        return refuse_with(400, "the first line of the request is not of the form `METHOD /PATH HTTP/1.1`");
    }
    if (version != "HTTP/1.1" && version != "HTTP/1.0") {
        return refuse_with(505, "the panel supports HTTP/1.1 and HTTP/1.0; send one of these versions");
    }
    const auto question = std::min(target.find('?'), target.size());
    const std::string query = target.substr(std::min(question + 1, target.size()));
    request_.path = target.substr(0, question);
    request_.changes_from = number_in(query, "changes");
    request_.frames_from = number_in(query, "frames");
    part_ = Part::headers;
}

void HttpRequest::read_header() {
    if (line_.empty()) {
        part_ = length_ == 0 ? Part::done : Part::body;
        return;
    }
    const auto colon = line_.find(':');
    const auto end_of_name = line_.begin() + static_cast<std::ptrdiff_t>(std::min(colon, line_.size()));
    if (colon == std::string::npos || colon == 0 || !std::all_of(line_.begin(), end_of_name, is_token)) {
        return refuse_with(400, "a header is not of the form `NAME: VALUE` on one line");
    }
    keep_header(lower(line_.substr(0, colon)), trimmed(line_.substr(colon + 1)));
}

void HttpRequest::keep_header(const std::string& name, const std::string& value) {
    const std::map<std::string, std::string*> kept{{"host", &request_.host},
                                                   {"origin", &request_.origin},
                                                   {"sec-fetch-site", &request_.fetch_site},
                                                   {"content-type", &request_.content_type}};
    const auto place = kept.find(name);
    if (name == "transfer-encoding") {
        return refuse_with(411, "Transfer-Encoding is not supported; send the body with a Content-Length");
    }
    if (name == "expect") {
        return refuse_with(417, "the header Expect is not supported; send the body at once");
    }
    if (place == kept.end() && name != "content-length") {
        return;
    }
    if (!seen_.insert(name).second) {
        return refuse_with(400, fmt::format("the header {} occurs twice; send it once", name));
    }
    if (place != kept.end()) {
        *place->second = value;
    } else {
        read_length(value);
    }
}

void HttpRequest::read_length(const std::string& value) {
    if (value.empty() || !std::all_of(value.begin(), value.end(), is_digit)) {
        return refuse_with(400, "Content-Length is not a number; send the length of the body in bytes");
    }
    std::from_chars(value.data(), value.data() + std::min(value.size(), longest_number), length_);
    if (value.size() > longest_number || length_ > longest_body) {
        refuse_with(413,
                    fmt::format("the body of a request may have at most {} bytes; send a shorter body", longest_body));
    }
}

void HttpRequest::refuse_with(int status, const std::string& why) {
    refusal_ = error_response(status, why);
}

}  // namespace canproof::host
