// SPDX-License-Identifier: Apache-2.0
// One 32-bit register of a peripheral. Only read() and write() access it. A test links other definitions of both, which
// pass each access to a model of the peripheral.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::stm32f405 {

class Register {
  public:
    std::uint32_t read() const noexcept;
    void write(std::uint32_t bits) noexcept;

    /// Returns whether any bit of `mask` is set.
    bool has(const std::uint32_t mask) const noexcept { return (read() & mask) != 0U; }
    /// Reads the register, replaces the bits of `mask` by those of `bits` and writes it. Must not be used for a
    /// register in which a read or a written 1 has an effect.
    void replace(const std::uint32_t mask, const std::uint32_t bits) noexcept {
        write((read() & ~mask) | (bits & mask));
    }
    void set(const std::uint32_t mask) noexcept { replace(mask, mask); }
    void clear(const std::uint32_t mask) noexcept { replace(mask, 0U); }

  private:
    // Not used where a test provides its own read() and write().
    [[maybe_unused]] volatile std::uint32_t bits_{0U};
};

static_assert(sizeof(Register) == sizeof(std::uint32_t), "registers lie one behind the other");

/// A gap between two registers.
template <std::size_t Count>
using Reserved = std::array<std::uint32_t, Count>;

/// Returns a number in which only bit `position` (0…31) is set.
constexpr std::uint32_t bit(const std::uint32_t position) noexcept {
    return std::uint32_t{1U} << position;
}

}  // namespace canproof::stm32f405
