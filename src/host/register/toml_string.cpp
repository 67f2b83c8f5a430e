// SPDX-License-Identifier: Apache-2.0
#include "host/register/toml_string.hpp"

#include <fmt/format.h>

namespace canproof::host {

std::string toml_string(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            out += {'\\', letter};
        } else if (byte < 0x20 || byte == 0x7F) {
            out += fmt::format("\\u{:04X}", byte);
        } else {
            out += letter;
        }
    }
    return out + "\"";
}

}  // namespace canproof::host
