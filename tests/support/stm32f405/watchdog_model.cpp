// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace canproof::test {

namespace {

constexpr std::uint32_t cycles_of_an_update = 5;  // at most, of the oscillator (RM0090 21.4.4)

}  // namespace

void WatchdogModel::pass(double ms, double khz) {
    if (ms * khz >= cycles_of_an_update) {
        prescaler_.take();
        reload_.take();
    }
    left_ -= running_ ? ms * khz / (4U << prescaler_.value) : 0;
    bitten_ = bitten_ || left_ < 0;
}

std::uint32_t WatchdogModel::on_read(std::size_t offset) {
    switch (offset) {
        case 0x04:
            return prescaler_.value;
        case 0x08:
            return reload_.value;
        case 0x0C:
            break;
        default:
            return 0;
    }
    for (Updated* one : {&prescaler_, &reload_}) {
        if (one->reads == 1) {
            one->take();
        }
        one->reads -= one->reads > 1 ? 1 : 0;
    }
    return (prescaler_.reads > 0 ? 1U : 0U) | (reload_.reads > 0 ? 2U : 0U);
}

void WatchdogModel::on_write(std::size_t offset, std::uint32_t bits) {
    if (offset == 0x00) {
        accessible_ = bits == 0x5555;
        running_ = running_ || bits == 0xCCCC;
        if (bits == 0xAAAA || bits == 0xCCCC) {
            left_ = reload_.value + 1.0;
        }
        refreshes_ += bits == 0xAAAA ? 1 : 0;
        return;
    }
    if (!accessible_ || offset == 0x0C) {
        return fault("a write to a protected register");
    }
    write(offset == 0x04 ? prescaler_ : reload_, bits);
}

/// A register may be written only while its flag in IWDG_SR is not set (RM0090 21.4.4).
void WatchdogModel::write(Updated& one, std::uint32_t bits) {
    if (one.reads > 0) {
        return fault("a write while the update of the register runs");
    }
    one.next = bits;
    one.reads = cycles_of_an_update;
}

}  // namespace canproof::test
