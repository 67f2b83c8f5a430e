// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

std::uint32_t Register::read() const noexcept {
    return bits_;
}

void Register::write(const std::uint32_t bits) noexcept {
    bits_ = bits;
}

}  // namespace canproof::stm32f405
