// SPDX-License-Identifier: Apache-2.0
// Effects of an SDO download on the naive model of the CAN-CBX-AO412 (manual, 7.9 to 7.11).
#include "properties/devices/cbx-ao412/naive_cbx_ao412.hpp"

namespace canproof::naive_ao4 {

namespace {

constexpr std::uint32_t refused_range = 0x06090030;
constexpr std::uint32_t refused_state = 0x08000022;

}  // namespace

void Device::write(unsigned index, unsigned sub, std::uint32_t value) {
    const std::uint32_t refused = change(index, sub, value);
    sent_.push_back(text_of(0x580 + node_, {refused == 0 ? 0x60U : 0x80U, index, index >> 8U, sub, refused,
                                            refused >> 8U, refused >> 16U, refused >> 24U}));
}

std::uint32_t Device::change(unsigned index, unsigned sub, std::uint32_t value) {
    if (index == 0x1003) {
        if (value != 0) {
            return refused_range;
        }
        list_.clear();
        return 0;
    }
    if (index == 0x1010) {
        if (state_ != State::pre_operational) {
            return refused_state;
        }
        stored_ = settings_;
        return 0;
    }
    if (index == 0x1011) {
        stored_ = shipped_;
        return 0;
    }
    return index < 0x2000 ? change_supervision(index, sub, value)
                          : change_output(index, settings_.outputs[sub - 1], outputs_[sub - 1], value);
}

std::uint32_t Device::change_output(unsigned index, OutputSettings& set, Output& output, std::uint32_t value) {
    const int number = static_cast<std::int16_t>(value);
    switch (index) {
        case 0x6411:
            set.command = number;
            if (!failed_) {
                output.command(number);
            }
            return 0;
        case 0x6443:
            if ((value & 0xFFU) > 2) {
                return refused_range;
            }
            set.error_mode = value & 0xFFU;
            return 0;
        case 0x6444:
            set.error_value = static_cast<std::int32_t>(value);
            return 0;
        case 0x2404:
            set.offset = number;
            return 0;
        default:
            set.gain = number;
            return 0;
    }
}

std::uint32_t Device::change_supervision(unsigned index, unsigned sub, std::uint32_t value) {
    switch (index) {
        case 0x1015:
            settings_.inhibit_ms = value / 10;
            return 0;
        case 0x1016:
            settings_.consumer_node = value >> 16U;
            settings_.consumer_ms = value & 0xFFFFU;
            producer_silent_ = false;
            producer_due_.reset();
            return 0;
        case 0x1017:
            settings_.heartbeat_ms = value;
            next_heartbeat_.reset();
            if (value != 0) {
                next_heartbeat_ = now_ + value;
                guarded_until_.reset();
                guarding_failed_ = false;
            }
            return 0;
        case 0x100C:
        case 0x100D:
            (index == 0x100C ? settings_.guard_ms : settings_.life_factor) = value;
            guarding_failed_ = guarding_failed_ && settings_.guard_ms * settings_.life_factor != 0;
            if (guarded_until_) {
                const unsigned life_ms = settings_.guard_ms * settings_.life_factor;
                guarded_until_ = life_ms == 0 ? std::nullopt : std::optional<std::uint64_t>{now_ + life_ms};
            }
            return 0;
        case 0x1029:
            settings_.behaviour = value > 2 ? settings_.behaviour : value;
            return value > 2 ? refused_range : 0;
        case 0x1401:
            settings_.rpdo_type = value;
            waiting_rpdo_.reset();
            return 0;
        case 0x1F80:
            settings_.start = value == 2 || value == 8 ? value : settings_.start;
            return value == 2 || value == 8 ? 0 : refused_range;
        default:
            settings_.start_ms = sub == 1 ? value : settings_.start_ms;
            return 0;
    }
}

}  // namespace canproof::naive_ao4
