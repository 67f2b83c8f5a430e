// FNV-1a (32 bit) of text: the fingerprint of layouts and of reviewed requirements.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

/// `start`: the hash of what stands before the text.
std::uint32_t fnv1a(const std::string& text, std::uint32_t start = 0x811C9DC5U);

}  // namespace canproof::host
