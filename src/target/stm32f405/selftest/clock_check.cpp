// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/clock_check.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// Bits of the registers of TIM5 (RM0090 18.4.5, 18.4.8, 18.4.9, 18.4.20).
constexpr std::uint32_t captured = bit(4U);            // CC4IF of TIM5_SR; a read of TIM5_CCR4 clears it
constexpr std::uint32_t missed = bit(12U);             // CC4OF: a capture came before the last one was read
constexpr std::uint32_t capture_on = bit(12U);         // CC4E of TIM5_CCER
constexpr std::uint32_t input_4 = 0x1U << 8U;          // CC4S of TIM5_CCMR2: channel 4 captures its own input
constexpr std::uint32_t every_eighth = 0x3U << 10U;    // IC4PSC
constexpr std::uint32_t from_oscillator = 0x1U << 6U;  // TI4_RMP of TIM5_OR: the low-speed oscillator

}  // namespace

void ClockCheck::start(const Instant now) noexcept {
    TimerRegisters& timer = registers_.timer;
    registers_.option.write(from_oscillator);
    timer.prescaler.write(0U);
    timer.reload.write(UINT32_MAX);
    timer.events.write(tim::update);
    timer.compare_mode[1U].write(input_4 | every_eighth);
    timer.compare_enable.write(capture_on);
    timer.control.write(tim::enable);
    seen_ = now;
    has_last_ = false;
}

static_assert(implements<req::CO_SELF_006> && implements<req::CO_SELF_015>);
bool ClockCheck::step(const Instant now) noexcept {
    TimerRegisters& timer = registers_.timer;
    if (!timer.status.has(captured)) {
        return elapsed(seen_, now).us < most_wait.us;
    }
    seen_ = now;
    const std::uint32_t capture = timer.compare[3U].read();
    // Reads this flag after the capture, because another capture between the two reads would make the interval twice as
    // long.
    const bool is_alone = !timer.status.has(missed);
    if (!is_alone) {
        timer.status.write(~missed);  // clears only this flag: a written 1 changes no flag
    }
    const bool is_right = !is_alone || !has_last_ || is_plausible(capture);
    last_ = capture;
    has_last_ = true;
    return is_right;
}

bool ClockCheck::is_plausible(const std::uint32_t capture) const noexcept {
    const std::uint32_t counts = capture - last_;
    return (counts >= (shortest_us * timer_mhz_)) && (counts <= (longest_us * timer_mhz_));
}

}  // namespace canproof::stm32f405
