// SPDX-License-Identifier: Apache-2.0
#include "host/base/one_line.hpp"

namespace canproof::host {

std::string one_line(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!space) {
            out += c;
        } else if (!out.empty() && out.back() != ' ') {
            out += ' ';
        }
    }
    while (!out.empty() && out.back() == ' ') {
        out.pop_back();
    }
    return out;
}

std::string brief(const std::string& text) {
    constexpr std::size_t longest = 90;
    return text.size() <= longest ? text : text.substr(0, text.rfind(' ', longest)) + " …";
}

}  // namespace canproof::host
