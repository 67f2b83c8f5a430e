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
    if (text.size() <= longest) {
        return text;
    }
    std::size_t end = text.rfind(' ', longest);
    if (end == std::string::npos) {
        constexpr unsigned char kind_of_byte = 0xC0U;
        constexpr unsigned char further_byte = 0x80U;  // a byte after the first of a UTF-8 character
        end = longest;
        while (end > 0U && (static_cast<unsigned char>(text[end]) & kind_of_byte) == further_byte) {
            --end;
        }
    }
    return text.substr(0, end) + " …";
}

}  // namespace canproof::host
