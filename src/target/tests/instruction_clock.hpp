// SPDX-License-Identifier: Apache-2.0
// Counts the instructions between two points with SysTick. Under `qemu -icount shift=4` each instruction takes 16 ns of
// the virtual clock, and SysTick runs at 168 MHz. The result is a count, not a time: it excludes flash wait states and
// the pipeline.
#pragma once

#include <cstdint>

namespace canproof::target {

class InstructionClock {
  public:
    /// Measures how many instructions a measurement itself takes; instructions() subtracts them.
    InstructionClock();

    void start() const;
    /// Returns the instructions since start(), accurate to one instruction, up to six million; UINT32_MAX beyond.
    std::uint32_t instructions() const;

  private:
    std::uint32_t own_{0};
};

}  // namespace canproof::target
