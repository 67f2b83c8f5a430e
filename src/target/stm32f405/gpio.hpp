// SPDX-License-Identifier: Apache-2.0
// General-purpose pins (RM0090 8.3, 8.4).
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

struct GpioRegisters {
    Register mode;                       ///< 00h GPIOx_MODER (8.4.1)
    Register output_type;                ///< 04h GPIOx_OTYPER (8.4.2)
    Register speed;                      ///< 08h GPIOx_OSPEEDR (8.4.3)
    Register pull;                       ///< 0Ch GPIOx_PUPDR (8.4.4)
    Register input;                      ///< 10h GPIOx_IDR (8.4.5)
    Register output;                     ///< 14h GPIOx_ODR (8.4.6)
    Register set_reset;                  ///< 18h GPIOx_BSRR (8.4.7)
    Register lock;                       ///< 1Ch GPIOx_LCKR (8.4.8)
    std::array<Register, 2U> alternate;  ///< 20h GPIOx_AFRL, GPIOx_AFRH (8.4.9, 8.4.10)
};

enum class PinMode : std::uint8_t { input = 0U, output = 1U, alternate = 2U, analog = 3U };

/// A port of 16 pins, 0…15.
class Port {
  public:
    explicit Port(GpioRegisters& registers) noexcept : registers_{registers} {}

    /// Sets the mode of a pin. `function` (0…15) is used for PinMode::alternate only.
    void configure(std::uint32_t pin, PinMode mode, std::uint32_t function = 0U) noexcept;
    void pull_up(std::uint32_t pin) noexcept;
    /// Returns the levels of `count` pins from `first` on, the first in bit 0.
    std::uint32_t read(std::uint32_t first, std::uint32_t count) const noexcept;
    bool is_high(const std::uint32_t pin) const noexcept { return read(pin, 1U) != 0U; }
    void set(std::uint32_t pin, bool high) noexcept;

  private:
    GpioRegisters& registers_;
};

}  // namespace canproof::stm32f405
