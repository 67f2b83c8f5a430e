// SPDX-License-Identifier: Apache-2.0
#include "host/base/fnv1a.hpp"

namespace canproof::host {

std::uint32_t fnv1a(const std::string& text, std::uint32_t start) {
    std::uint32_t hash = start;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193U;
    }
    return hash;
}

}  // namespace canproof::host
