// SPDX-License-Identifier: Apache-2.0
// Feeds the HTTP reader of the panel with any bytes, in pieces of any size. Checks that memory stays bounded, that the
// sizes of the pieces do not change the result, and that accepted requests contain nothing that HTTP forbids. Input:
// pieces, each a byte with its size and then that many bytes.
#include <algorithm>
#include <string>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/http/http_request.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t most_held = host::HttpRequest::longest_header_line + host::longest_body + 1U;

bool is_clean(const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char one) { return one == '\r' || one == '\n' || one == '\0'; });
}

void check(const host::HttpRequest& read) {
    require(read.held() <= most_held);
    if (read.refusal()) {
        require(read.refusal()->status >= 400 && read.refusal()->status < 506 && !read.refusal()->body.empty());
        return;
    }
    const host::PanelRequest& request = read.request();
    require(is_clean(request.method) && is_clean(request.path) && is_clean(request.host) && is_clean(request.origin) &&
            is_clean(request.fetch_site) && is_clean(request.content_type));
    require(request.body.size() <= host::longest_body);
    if (read.is_done()) {
        require(request.path.front() == '/' && request.path.size() <= host::HttpRequest::longest_request_line);
        static_cast<void>(host::refuse(request));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text{data, data + size};
    host::HttpRequest pieces;
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = std::min<std::size_t>(data[at], text.size() - at - 1);
        pieces.take(std::string_view{text}.substr(at + 1, length));
        all += text.substr(at + 1, length);
        check(pieces);
        at += length + 1;
    }
    host::HttpRequest whole;
    whole.take(all);
    check(whole);
    require(whole.is_done() == pieces.is_done() && whole.refusal().has_value() == pieces.refusal().has_value());
    require(whole.request().path == pieces.request().path && whole.request().body == pieces.request().body);
    require(!whole.refusal() || whole.refusal()->status == pieces.refusal()->status);
    return 0;
}
