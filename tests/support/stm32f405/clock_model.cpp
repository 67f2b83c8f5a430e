// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/clock_model.hpp"

namespace canproof::test {

namespace {

namespace cr = stm32f405::rcc_cr;

constexpr std::size_t at_cr = 0x00, at_pllcfgr = 0x04, at_cfgr = 0x08, at_apb1enr = 0x40, at_csr = 0x74;

}  // namespace

void PowerModel::on_write(std::size_t offset, std::uint32_t bits) {
    constexpr std::uint32_t power_clock = 1U << 28U, voltage = 1U << 14U;  // PWREN, VOS
    if ((clock_.enabled(at_apb1enr) & power_clock) == 0) {
        return fault("the power controller is written without its clock");
    }
    if (offset != 0 || (clock_.is_pll_on() && ((bits ^ control_) & voltage) != 0)) {
        return fault("the voltage is changed while the PLL is on, or another register is written");
    }
    control_ = bits;
}

bool ClockModel::is_locked() const {
    const bool has_source = (pll_ >> 22U & 1U) == 0 || has_crystal();
    return pll_works_ && has_source && (control_ & cr::pll_on) != 0;
}

/// Returns the frequency of the PLL's output: input / PLLM × PLLN / PLLP (RM0090 7.3.2).
double ClockModel::pll_mhz() const {
    const double input = (pll_ >> 22U & 1U) != 0 ? 8 : 16;
    return input / (pll_ & 0x3FU) * (pll_ >> 6U & 0x1FFU) / (2 * ((pll_ >> 16U & 3U) + 1));
}

double ClockModel::core_mhz() const {
    return (configuration_ & 3U) == 2 && switches_ ? pll_mhz() : 16;
}

double ClockModel::apb1_mhz() const {
    const std::uint32_t divider = configuration_ >> 10U & 7U;
    return core_mhz() / (divider < 4 ? 1 : 2U << (divider - 4));
}

std::uint32_t ClockModel::on_read(std::size_t offset) {
    if (enabled_.count(offset) != 0) {
        return enabled_.at(offset);
    }
    switch (offset) {
        case at_cr:
            return control_ | (has_crystal() ? cr::crystal_ready : 0) | (is_locked() ? cr::pll_ready : 0);
        case at_pllcfgr:
            return pll_;
        case at_cfgr:
            return configuration_ | (switches_ ? (configuration_ & 3U) << 2U : 0);
        case at_csr:
            return status_;
        default:
            fault("a read of another register");
            return 0;
    }
}

void ClockModel::on_write(std::size_t offset, std::uint32_t bits) {
    if (enabled_.count(offset) != 0) {
        enabled_[offset] = bits;
        return;
    }
    const double input = (bits >> 22U & 1U) != 0 ? 8 : 16;
    switch (offset) {
        case at_cr:
            control_ = bits & ~(cr::crystal_ready | cr::pll_ready);
            return;
        case at_pllcfgr:
            if (is_pll_on()) {
                fault("the PLL is configured while it is on");
            }
            if ((bits & 0x3FU) < 2 || input / (bits & 0x3FU) < 1 || input / (bits & 0x3FU) > 2) {
                fault("the PLL's input is not 1 to 2 MHz");
            }
            pll_ = bits;
            return;
        case at_cfgr:
            // A new divider is used only up to 16 cycles later (RM0090 7.3.3); meanwhile the buses would be too fast.
            if ((bits & 3U) == 2 && (bits & 0xFC00U) != (configuration_ & 0xFC00U)) {
                fault("the dividers of the buses are changed with the switch to the PLL");
            }
            configuration_ = bits;
            if ((bits & 3U) == 2 && !is_locked()) {
                fault("the core is switched to a PLL that has not locked");
            }
            // The flash needs one more wait state for each 30 MHz of the core's clock (RM0090 3.5.1). Above 144 MHz,
            // bit VOS (voltage scaling) must be set (RM0090 5.1.4).
            if (core_mhz() > 30.0 * ((flash_.at(0) & 7U) + 1)) {
                fault("too few wait states");
            }
            if (core_mhz() > 144 && (power_.control() & 1U << 14U) == 0) {
                fault("the voltage is not that for 168 MHz");
            }
            if (core_mhz() > 168 || apb1_mhz() > 42) {
                fault("a clock is above its limit");
            }
            return;
        case at_csr:
            // writing 1 to RMVF (bit 24) clears the flags that show the cause of the last reset
            status_ = (bits & 1U << 24U) != 0 ? 0 : status_;
            return;
        default:
            fault("a write to another register");
    }
}

}  // namespace canproof::test
