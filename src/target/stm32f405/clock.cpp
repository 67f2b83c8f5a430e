// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/clock.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// The PLL needs 1 to 2 MHz at its input, and 2 MHz for the least jitter; it divides its output by two (RM0090 7.3.2).
constexpr std::uint32_t crystal_mhz = 8U;
constexpr std::uint32_t internal_mhz = 16U;
constexpr std::uint32_t pll_input_mhz = 2U;
constexpr std::uint32_t usb_divider = 7U;

/// Five wait states are right for 150 to 168 MHz at 2.7 to 3.6 V, and enough for lower clocks (RM0090 3.5.1).
constexpr std::uint32_t wait_states = 5U;

constexpr std::uint32_t pll_configuration(const ClockPlan& plan, const std::uint32_t source_mhz) noexcept {
    return (source_mhz / pll_input_mhz) | (plan.core_mhz << rcc_pllcfgr::multiplier_shift) |
           (usb_divider << rcc_pllcfgr::usb_shift);
}

}  // namespace

bool Clock::waits_for(const Register& place, const std::uint32_t flag) const noexcept {
    for (std::uint32_t poll = 0U; poll < most_polls_; ++poll) {
        if (place.has(flag)) {
            return true;
        }
    }
    return false;
}

static_assert(implements<req::CO_CLOCK_001> && implements<req::CO_CLOCK_003>);
ClockSource Clock::start(const ClockPlan& plan) noexcept {
    clocks_.enable_apb[0U].set(power_clock);
    power_.control.set(full_voltage);
    flash_.access_control.write(wait_states | flash_acr::prefetch | flash_acr::instructions | flash_acr::data);
    clocks_.control.set(rcc_cr::crystal_on);
    const bool has_crystal = waits_for(clocks_.control, rcc_cr::crystal_ready);
    if (!has_crystal) {
        clocks_.control.clear(rcc_cr::crystal_on);
    }
    const std::uint32_t from_crystal = pll_configuration(plan, crystal_mhz) | rcc_pllcfgr::from_crystal;
    if (!runs_from_pll(has_crystal ? from_crystal : pll_configuration(plan, internal_mhz))) {
        static_assert(implements<req::CO_CLOCK_004>);
        return ClockSource::none;
    }
    if (has_crystal) {
        clocks_.control.set(rcc_cr::security_on);  // a crystal that fails later raises an NMI (RM0090 7.2.7)
    }
    return has_crystal ? ClockSource::crystal : ClockSource::internal;
}

bool Clock::runs_from_pll(const std::uint32_t configuration) noexcept {
    clocks_.pll.write(configuration);
    clocks_.control.set(rcc_cr::pll_on);
    if (!waits_for(clocks_.control, rcc_cr::pll_ready)) {
        return false;
    }
    clocks_.configuration.write(rcc_cfgr::apb1_by_4 | rcc_cfgr::apb2_by_2);
    clocks_.configuration.write(rcc_cfgr::apb1_by_4 | rcc_cfgr::apb2_by_2 | rcc_cfgr::use_pll);
    return waits_for(clocks_.configuration, rcc_cfgr::uses_pll);
}

bool Clock::take_watchdog_reset() noexcept {
    const bool by_watchdog = clocks_.status.has(rcc_csr::by_watchdog);
    clocks_.status.set(rcc_csr::forget);
    return by_watchdog;
}

}  // namespace canproof::stm32f405
