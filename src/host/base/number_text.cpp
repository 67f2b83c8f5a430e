// SPDX-License-Identifier: Apache-2.0
#include "host/base/number_text.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace canproof::host {

std::optional<double> decimal_number(const std::string& text) {
    // strtod() also accepts leading blanks, hexadecimal numbers, `inf` and `nan`.
    if (text.empty() || text.find_first_not_of("0123456789.+-eE") != std::string::npos) {
        return std::nullopt;
    }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return *end == '\0' && std::isfinite(value) ? std::optional<double>{value} : std::nullopt;
}

std::optional<double> decimal_or_hexadecimal(const std::string& text) {
    if (text.rfind("0x", 0) != 0 && text.rfind("0X", 0) != 0) {
        return decimal_number(text);
    }
    constexpr std::size_t longest = 18;  // 0x and the 16 digits of 64 bits
    const bool is_number = text.size() > 2 && text.size() <= longest &&
                           text.find_first_not_of("0123456789abcdefABCDEF", 2) == std::string::npos;
    return is_number ? std::optional<double>{static_cast<double>(std::stoull(text, nullptr, 16))} : std::nullopt;
}

}  // namespace canproof::host
