// SPDX-License-Identifier: Apache-2.0
// The clock tree: 8 MHz crystal or the chip's 16 MHz oscillator, PLL, dividers of the buses (RM0090 3.5.1, 5.4, 7.2,
// 7.3).
#pragma once

#include "target/stm32f405/flash.hpp"

namespace canproof::stm32f405 {

struct ClockRegisters {
    Register control;                    ///< 00h RCC_CR (7.3.1)
    Register pll;                        ///< 04h RCC_PLLCFGR (7.3.2)
    Register configuration;              ///< 08h RCC_CFGR (7.3.3)
    Register interrupts;                 ///< 0Ch RCC_CIR (7.3.4)
    std::array<Register, 3U> reset_ahb;  ///< 10h RCC_AHB1RSTR to RCC_AHB3RSTR (7.3.5 to 7.3.7)
    Reserved<1U> reserved_1c{};
    std::array<Register, 2U> reset_apb;  ///< 20h RCC_APB1RSTR, RCC_APB2RSTR (7.3.8, 7.3.9)
    Reserved<2U> reserved_28{};
    std::array<Register, 3U> enable_ahb;  ///< 30h RCC_AHB1ENR to RCC_AHB3ENR (7.3.10 to 7.3.12)
    Reserved<1U> reserved_3c{};
    std::array<Register, 2U> enable_apb;  ///< 40h RCC_APB1ENR, RCC_APB2ENR (7.3.13, 7.3.14)
    Reserved<2U> reserved_48{};
    std::array<Register, 3U> low_power_ahb;  ///< 50h RCC_AHB1LPENR to RCC_AHB3LPENR (7.3.15 to 7.3.17)
    Reserved<1U> reserved_5c{};
    std::array<Register, 2U> low_power_apb;  ///< 60h RCC_APB1LPENR, RCC_APB2LPENR (7.3.18, 7.3.19)
    Reserved<2U> reserved_68{};
    Register backup;  ///< 70h RCC_BDCR (7.3.20)
    Register status;  ///< 74h RCC_CSR (7.3.21)
};

static_assert(sizeof(ClockRegisters) == 0x78U, "RCC_CSR lies at 74h");

struct PowerRegisters {
    Register control;  ///< 00h PWR_CR (5.4.1)
    Register status;   ///< 04h PWR_CSR (5.4.2)
};

namespace rcc_cr {
constexpr std::uint32_t internal_on = bit(0U);     // HSION
constexpr std::uint32_t internal_ready = bit(1U);  // HSIRDY
constexpr std::uint32_t crystal_on = bit(16U);     // HSEON
constexpr std::uint32_t crystal_ready = bit(17U);  // HSERDY
constexpr std::uint32_t security_on = bit(19U);    // CSSON
constexpr std::uint32_t pll_on = bit(24U);         // PLLON
constexpr std::uint32_t pll_ready = bit(25U);      // PLLRDY
}  // namespace rcc_cr

namespace rcc_pllcfgr {
constexpr std::uint32_t multiplier_shift = 6U;  // PLLN. PLLM lies below it; PLLP = 2 is coded as 0
constexpr std::uint32_t from_crystal = bit(22U);
constexpr std::uint32_t usb_shift = 24U;  // PLLQ
}  // namespace rcc_pllcfgr

namespace rcc_cfgr {
constexpr std::uint32_t use_pll = 0x2U;           // SW
constexpr std::uint32_t uses_pll = bit(3U);       // SWS: 2; the value 3 does not occur
constexpr std::uint32_t apb1_by_4 = 0x5U << 10U;  // PPRE1
constexpr std::uint32_t apb2_by_2 = 0x4U << 13U;  // PPRE2
}  // namespace rcc_cfgr

namespace rcc_csr {
constexpr std::uint32_t forget = bit(24U);       // RMVF
constexpr std::uint32_t by_watchdog = bit(29U);  // IWDGRSTF
}  // namespace rcc_csr

constexpr std::uint32_t power_clock = bit(28U);   // PWREN of RCC_APB1ENR
constexpr std::uint32_t full_voltage = bit(14U);  // VOS of PWR_CR: required for 168 MHz

/// Clocks of a device's image. APB1, which clocks CAN, runs at a quarter of the core clock, its timers at half.
struct ClockPlan {
    std::uint32_t core_mhz{168U};  ///< an even number from 100 to 168

    constexpr std::uint32_t apb1_hz() const noexcept { return (core_mhz * 1000000U) / 4U; }
    constexpr std::uint32_t timer_mhz() const noexcept { return core_mhz / 2U; }
};

/// APB1 runs at 42 MHz, which is a multiple of 666.667 kbit/s but not of 800 kbit/s.
constexpr ClockPlan core_168_mhz{168U};
/// APB1 runs at 40 MHz, which is also a multiple of 800 kbit/s.
constexpr ClockPlan core_160_mhz{160U};

enum class ClockSource : std::uint8_t {
    crystal,
    internal,  ///< the crystal did not start; the error of the internal oscillator, 1 % or more, is too large for CAN
    none       ///< the PLL does not lock: the core runs at 16 MHz, and all times are wrong
};

class Clock {
  public:
    /// The limit of polls for the start of a crystal, which takes some milliseconds. A poll takes at least six cycles
    /// at 16 MHz, so this number of polls takes at least 37 ms.
    static constexpr std::uint32_t usual_polls = 100000U;

    Clock(ClockRegisters& clocks, PowerRegisters& power, FlashRegisters& flash,
          const std::uint32_t most_polls = usual_polls) noexcept
        : clocks_{clocks}, power_{power}, flash_{flash}, most_polls_{most_polls} {}

    /// Switches from the clocks that run after a reset to the clocks of `plan`.
    ClockSource start(const ClockPlan& plan) noexcept;
    /// Returns whether the watchdog caused the last reset, and clears that information.
    bool take_watchdog_reset() noexcept;

  private:
    bool waits_for(const Register& place, std::uint32_t flag) const noexcept;
    bool runs_from_pll(std::uint32_t configuration) noexcept;

    ClockRegisters& clocks_;
    PowerRegisters& power_;
    FlashRegisters& flash_;
    std::uint32_t most_polls_;
};

}  // namespace canproof::stm32f405
