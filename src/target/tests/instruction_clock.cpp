// SPDX-License-Identifier: Apache-2.0
#include "instruction_clock.hpp"

#include <cstddef>

#include "target/sys_tick.hpp"

namespace canproof::target {

namespace {

constexpr std::uint32_t enabled = 1U;
constexpr std::uint32_t processor_clock = 1U << 2U;
constexpr std::uint32_t has_wrapped = 1U << 16U;

/// Converts ticks to instructions: 16 ns at 168 MHz are 2.688 ticks, so 336 ticks are 125 instructions.
std::uint32_t instructions_of(std::uint32_t ticks) {
    return static_cast<std::uint32_t>((std::uint64_t{ticks} * 125U + 168U) / 336U);
}

}  // namespace

InstructionClock::InstructionClock() {
    sys_tick().reload = longest_sys_tick;
    sys_tick().control = enabled | processor_clock;
    start();
    own_ = instructions();
}

void InstructionClock::start() const {
    sys_tick().value = 0;                   // any write restarts the count
    static_cast<void>(sys_tick().control);  // a read clears has_wrapped
}

std::uint32_t InstructionClock::instructions() const {
    const std::uint32_t value = sys_tick().value;
    if ((sys_tick().control & has_wrapped) != 0U) {
        return UINT32_MAX;
    }
    const std::uint32_t all = instructions_of(value == 0U ? 0U : longest_sys_tick - value);
    return all < own_ ? 0U : all - own_;
}

}  // namespace canproof::target
