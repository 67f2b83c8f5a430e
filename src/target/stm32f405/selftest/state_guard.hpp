// SPDX-License-Identifier: Apache-2.0
// A checksum of an object, kept while nothing may change it, so that a change in RAM is noticed before the object is
// used.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof::stm32f405 {

/// Returns the bytes of an object. The padding between its members is included; nothing changes it either.
template <typename Object>
ByteView object_bytes(const Object& object) noexcept {
    static_assert((sizeof(Object) % sizeof(std::uint32_t)) == 0U, "the checksum adds whole words");
    return ByteView{reinterpret_cast<const std::uint8_t*>(&object), sizeof(Object)};
}

/// For each word of 32 bits, the checksum is rotated by one bit and the word is added. Each step has an inverse, so one
/// changed word always changes the checksum. Two changed words cancel each other out in one of 2^32 cases.
class StateGuard {
  public:
    /// The size of `object` must be a whole number of words.
    explicit StateGuard(const ByteView object) noexcept : object_{object} {}

    void keep() noexcept { complement_ = ~sum(); }
    /// Returns whether the object is as it was at the last keep().
    bool matches() const noexcept { return complement_ == ~sum(); }
    /// Returns the checksum of the object as it is now.
    std::uint32_t sum() const noexcept;

  private:
    ByteView object_;
    std::uint32_t complement_{0U};
};

}  // namespace canproof::stm32f405
