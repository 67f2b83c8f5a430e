// SPDX-License-Identifier: Apache-2.0
#include "host/report/markup.hpp"

#include <algorithm>
#include <cctype>

namespace canproof::host {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string prose(const std::string& text) {
    return prose(text, escaped);
}

std::string prose(const std::string& text, const std::function<std::string(const std::string&)>& plain) {
    std::string out;
    std::size_t at = 0;
    for (;;) {
        const auto begin = text.find('`', at);
        const auto end = begin == std::string::npos ? begin : text.find('`', begin + 1);
        out += plain(text.substr(at, end == std::string::npos ? end : begin - at));
        if (end == std::string::npos) {
            return out;
        }
        out += "<code>" + escaped(text.substr(begin + 1, end - begin - 1)) + "</code>";
        at = end + 1;
    }
}

std::string breakable(const std::string& name) {
    std::string out;
    char before = '\0';
    for (const char c : name) {
        const bool is_hump =
            std::islower(static_cast<unsigned char>(before)) != 0 && std::isupper(static_cast<unsigned char>(c)) != 0;
        out += is_hump || before == '_' || before == '/' || before == '.' ? "<wbr>" : "";
        out += escaped(std::string(1, c));
        before = c;
    }
    return out;
}

std::string grouped(std::string number) {
    constexpr std::size_t group = 3;
    const std::size_t first = number.find('-') == 0 ? 1 : 0;
    for (std::size_t at = std::min(number.find('.'), number.size()); at > first + group;) {
        at -= group;
        number.insert(at, ",");
    }
    return number;
}

std::string grouped(const std::uint64_t number) {
    return grouped(std::to_string(number));
}

}  // namespace canproof::host
