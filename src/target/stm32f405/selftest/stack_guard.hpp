// SPDX-License-Identifier: Apache-2.0
// Guard words below the memory of the stack. A stack that writes over them has outgrown its memory; one that jumps over
// them without a write is not noticed.
#pragma once

#include "firmware/base/slots.hpp"
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

class StackGuard {
  public:
    static constexpr std::uint32_t pattern = 0x5AC3965AU;

    explicit StackGuard(const Slots<Register>& words) noexcept : words_{words} {}

    void start() noexcept;
    bool is_intact() const noexcept;

  private:
    Slots<Register> words_;
};

}  // namespace canproof::stm32f405
