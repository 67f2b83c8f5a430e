// Entries of an object dictionary in words: what they are called, what their bytes mean.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/base/bytes.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// An entry of the register; nullptr when `part` is, or when it has none there.
const Entry* entry_at(const Part* part, std::uint16_t index, std::uint8_t subindex);

/// `4020h:1 TC 1 High Shutdown Threshold`; the numbers alone when the entry is unknown, without `:0` for an object of
/// one value.
std::string entry_words(const Part* part, std::uint16_t index, std::uint8_t subindex);

/// Little-endian bytes as the entry's type reads them; as hexadecimal digits where the type is unknown or another
/// length.
std::string value_words(const Entry* entry, ByteView bytes);

}  // namespace canproof::host
