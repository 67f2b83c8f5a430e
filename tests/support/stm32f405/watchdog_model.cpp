// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace canproof::test {

void WatchdogModel::pass(double ms, double khz) {
    left_ -= running_ ? ms * khz / (4U << prescaler_) : 0;
    bitten_ = bitten_ || left_ < 0;
}

std::uint32_t WatchdogModel::on_read(std::size_t offset) {
    switch (offset) {
        case 0x04:
            return prescaler_;
        case 0x08:
            return reload_;
        case 0x0C:
            updating_reads_ -= updating_reads_ > 0 ? 1 : 0;
            return updating_reads_ > 0 || stays_updating_ ? 3 : 0;
        default:
            return 0;
    }
}

void WatchdogModel::on_write(std::size_t offset, std::uint32_t bits) {
    if (offset == 0x00) {
        accessible_ = bits == 0x5555;
        running_ = running_ || bits == 0xCCCC;
        if (bits == 0xAAAA || bits == 0xCCCC) {
            left_ = reload_ + 1.0;
        }
        refreshes_ += bits == 0xAAAA ? 1 : 0;
        return;
    }
    if (!accessible_ || offset == 0x0C) {
        return fault("a write to a protected register");
    }
    (offset == 0x04 ? prescaler_ : reload_) = bits;
    updating_reads_ = 5;
}

}  // namespace canproof::test
