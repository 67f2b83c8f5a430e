// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/gpio.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::uint32_t pins_a_function_register = 8U;
constexpr std::uint32_t pull_up_bits = 1U;
constexpr std::uint32_t pull_up_mask = 3U;
constexpr std::uint32_t reset_shift = 16U;  // BR0 of GPIOx_BSRR

}  // namespace

void Port::configure(const std::uint32_t pin, const PinMode mode, const std::uint32_t function) noexcept {
    const std::uint32_t shift = 4U * (pin % pins_a_function_register);
    registers_.alternate[pin / pins_a_function_register].replace(0xFU << shift, function << shift);
    registers_.mode.replace(3U << (2U * pin), static_cast<std::uint32_t>(mode) << (2U * pin));
}

void Port::pull_up(const std::uint32_t pin) noexcept {
    registers_.pull.replace(pull_up_mask << (2U * pin), pull_up_bits << (2U * pin));
}

static_assert(implements<req::CO_IMAGE_002>);
std::uint32_t Port::read(const std::uint32_t first, const std::uint32_t count) const noexcept {
    return (registers_.input.read() >> first) & (bit(count) - 1U);
}

/// Sets a pin with one write, which affects no other pin of the port.
static_assert(implements<req::CO_IMAGE_003>);
void Port::set(const std::uint32_t pin, const bool high) noexcept {
    registers_.set_reset.write(high ? bit(pin) : (bit(pin) << reset_shift));
}

}  // namespace canproof::stm32f405
