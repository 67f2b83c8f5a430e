// SPDX-License-Identifier: Apache-2.0
// A 64-bit count of microseconds from a 32-bit timer (TIM2, RM0090 chapter 18).
#pragma once

#include "firmware/base/time.hpp"
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

/// The registers of TIM2 to TIM5. TIM3 and TIM4 count in 16 bits.
struct TimerRegisters {
    Register control;                       ///< 00h TIMx_CR1
    Register control_2;                     ///< 04h TIMx_CR2
    Register slave_mode;                    ///< 08h TIMx_SMCR
    Register interrupts;                    ///< 0Ch TIMx_DIER
    Register status;                        ///< 10h TIMx_SR
    Register events;                        ///< 14h TIMx_EGR
    std::array<Register, 2U> compare_mode;  ///< 18h TIMx_CCMR1, TIMx_CCMR2
    Register compare_enable;                ///< 20h TIMx_CCER
    Register counter;                       ///< 24h TIMx_CNT
    Register prescaler;                     ///< 28h TIMx_PSC
    Register reload;                        ///< 2Ch TIMx_ARR
    Reserved<1U> reserved_30{};
    std::array<Register, 4U> compare;  ///< 34h TIMx_CCR1 to TIMx_CCR4
};

static_assert(sizeof(TimerRegisters) == 0x44U, "TIMx_CCR4 lies at 40h");

namespace tim {
constexpr std::uint32_t enable = bit(0U);  // CEN of TIMx_CR1
constexpr std::uint32_t update = bit(0U);  // UG of TIMx_EGR
}  // namespace tim

class TimeBase {
  public:
    /// `timer_mhz`: the clock of the timer, a whole number of MHz.
    TimeBase(TimerRegisters& timer, const std::uint32_t timer_mhz) noexcept : timer_{timer}, timer_mhz_{timer_mhz} {}

    void start() noexcept;
    /// Returns the microseconds since start(). Must be called at least once in 71 minutes, because the 32-bit timer
    /// then wraps, and by one caller only.
    Instant now() noexcept;

  private:
    TimerRegisters& timer_;
    std::uint32_t timer_mhz_;
    std::uint32_t last_{0U};
    std::uint64_t wraps_{0U};
};

}  // namespace canproof::stm32f405
