// SPDX-License-Identifier: Apache-2.0
// FNV-1a (32 bit) of text, for the fingerprints of parameter layouts and of reviewed requirements.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

/// Returns the hash of the text. To continue a hash, `start` is the hash of the preceding text.
std::uint32_t fnv1a(const std::string& text, std::uint32_t start = 0x811C9DC5U);

}  // namespace canproof::host
