// SPDX-License-Identifier: Apache-2.0
// A 64-bit count of microseconds from a 32-bit timer (TIM2, RM0090 18.4).
#pragma once

#include "firmware/base/time.hpp"
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

/// The registers of TIM2 to TIM5. TIM3 and TIM4 count in 16 bits.
struct TimerRegisters {
    Register control;                       ///< 00h TIMx_CR1 (18.4.1)
    Register control_2;                     ///< 04h TIMx_CR2 (18.4.2)
    Register slave_mode;                    ///< 08h TIMx_SMCR (18.4.3)
    Register interrupts;                    ///< 0Ch TIMx_DIER (18.4.4)
    Register status;                        ///< 10h TIMx_SR (18.4.5)
    Register events;                        ///< 14h TIMx_EGR (18.4.6)
    std::array<Register, 2U> compare_mode;  ///< 18h TIMx_CCMR1, TIMx_CCMR2 (18.4.7, 18.4.8)
    Register compare_enable;                ///< 20h TIMx_CCER (18.4.9)
    Register counter;                       ///< 24h TIMx_CNT (18.4.10)
    Register prescaler;                     ///< 28h TIMx_PSC (18.4.11)
    Register reload;                        ///< 2Ch TIMx_ARR (18.4.12)
    Reserved<1U> reserved_30{};
    std::array<Register, 4U> compare;  ///< 34h TIMx_CCR1 to TIMx_CCR4 (18.4.13 to 18.4.16)
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
