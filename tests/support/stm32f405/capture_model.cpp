// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/capture_model.hpp"

#include <cmath>

namespace canproof::test {

namespace {

constexpr std::uint32_t cc4if = 1U << 4U, cc4of = 1U << 12U;

}  // namespace

/// Returns whether channel 4 is an input from its own pin (CC4S = 01), captures (CC4E), gets the oscillator (TI4_RMP =
/// 01), and the counter runs (CEN).
bool CaptureModel::captures() const {
    return (mode_ >> 8U & 3U) == 1 && (enable_ >> 12U & 1U) == 1 && (option_ >> 6U & 3U) == 1 && (control_ & 1U) == 1;
}

void CaptureModel::capture(double count) {
    status_ |= (status_ & cc4if) != 0 ? cc4of : cc4if;
    captured_ = static_cast<std::uint32_t>(std::fmod(count, 4294967296.0));
}

void CaptureModel::pass(double us) {
    const double edges_per_capture = 1U << (mode_ >> 10U & 3U);  // IC4PSC: one capture for every 1, 2, 4 or 8 edges
    double left = us;
    while (captures() && oscillator_khz > 0) {
        const double until = (edges_per_capture - edges_) * 1000 / oscillator_khz;
        if (until > left) {
            edges_ += left * oscillator_khz / 1000;
            break;
        }
        left -= until;
        edges_ = 0;
        count_ += until * timer_mhz;
        capture(count_);
    }
    count_ += left * timer_mhz;
}

std::uint32_t CaptureModel::on_read(std::size_t offset) {
    switch (offset) {
        case 0x10:
            return status_;
        case 0x40:
            if (before_read_) {
                before_read_ = false;
                capture(count_);
            }
            status_ &= ~cc4if;
            return captured_;
        default:
            fault("a read of another register");
            return 0;
    }
}

void CaptureModel::on_write(std::size_t offset, std::uint32_t bits) {
    switch (offset) {
        case 0x00:
            control_ = bits;
            return;
        case 0x10:
            status_ &= bits;
            return;
        case 0x1C:
            if ((enable_ >> 12U & 1U) != 0) {
                fault("CC4S is written while the channel is on");
            }
            mode_ = bits;
            return;
        case 0x20:
            enable_ = bits;
            return;
        case 0x14:
            return;  // an update event
        case 0x28:
        case 0x2C:
            if (bits != (offset == 0x28 ? 0 : 0xFFFFFFFF)) {
                fault("the timer does not count each clock in 32 bits");
            }
            return;
        case 0x50:
            option_ = bits;
            return;
        default:
            fault("a write to another register");
    }
}

}  // namespace canproof::test
