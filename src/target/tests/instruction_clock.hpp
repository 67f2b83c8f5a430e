// Instructions between two points, by SysTick: under `qemu -icount shift=4` each instruction takes 16 ns of the virtual
// clock, by which SysTick runs at 168 MHz. A count, not a time: neither flash wait states nor the pipeline are in it.
#pragma once

#include <cstdint>

namespace canproof::target {

class InstructionClock {
  public:
    /// Measures what measuring itself takes.
    InstructionClock();

    void start() const;
    /// Since start(); right to one instruction, up to six million. UINT32_MAX beyond.
    std::uint32_t instructions() const;

  private:
    std::uint32_t own_{0};
};

}  // namespace canproof::target
