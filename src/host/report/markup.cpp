// SPDX-License-Identifier: Apache-2.0
#include "host/report/markup.hpp"

#include <algorithm>

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
