// SPDX-License-Identifier: Apache-2.0
// Naive parameters of the AX188001 (manual, 3.2 to 3.4): which writes are refused, and the effects of accepted writes.
// Shares no code with the firmware.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace canproof::naive_tcs {

constexpr std::uint32_t refused_range = 0x06090030;
constexpr std::uint32_t refused_high = 0x06090031;
constexpr std::uint32_t refused_low = 0x06090032;

struct Channel {
    unsigned type{1};
    bool enabled{true};
    bool compensated{true};
    float factor{16.0F};
    float offset{4368.0F};
    int low{-200};
    int high{1250};
    int shutdown{2500};
    unsigned delay_ms{5000};
};

/// The parameters of a TPDO. The model does not cover the inhibit time.
struct Tpdo {
    struct Mapped {
        unsigned index;
        unsigned sub;
        unsigned bytes;
    };
    bool valid{false};
    unsigned event_ms{0};
    std::vector<Mapped> mapped;
};

struct Communication {
    std::array<unsigned, 4> reaction{3, 0, 1, 0};  ///< 1029h (error behaviour) by sub-index
    std::array<Tpdo, 4> tpdos{{{true, 1000, {{0x7130, 1, 2}, {0x7130, 2, 2}}},
                               {false, 0, {{0x2130, 0, 2}, {0x3130, 0, 2}}},
                               {false, 0, {}},
                               {false, 0, {}}}};
};

struct Application {
    std::array<Channel, 2> channel{};
    unsigned filter_hz{60};
    bool averages{true};
    float average_factor{16.0F};
    float average_offset{4368.0F};
    float cj_factor{16.0F};
    float cj_offset{4368.0F};
    std::array<unsigned, 3> fd_set{1100, 500, 90};
    std::array<unsigned, 3> fd_clear{850, 480, 120};
    std::array<bool, 2> fd_enabled{true, true};
    std::array<unsigned, 2> fd_delay_ms{5000, 5000};
    unsigned start{0};
    unsigned start_delay_ms{1000};
};

template <typename Number, typename Limit>
std::uint32_t within(Number value, Limit low, Limit high) {
    if (value > high) {
        return refused_high;
    }
    return value < low ? refused_low : 0;
}

inline std::uint32_t one_of(unsigned value, const std::vector<unsigned>& allowed) {
    for (const unsigned one : allowed) {
        if (one == value) {
            return 0;
        }
    }
    return refused_range;
}

template <typename Target, typename Value>
std::uint32_t keep(std::uint32_t refused, Target& target, Value value) {
    if (refused == 0) {
        target = static_cast<Target>(value);
    }
    return refused;
}

inline std::uint32_t keep_real(float& target, std::uint32_t bits, float limit) {
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return keep(std::isfinite(value) ? within(value, -limit, limit) : refused_range, target, value);
}

/// Writes an object that has one sub-index per channel (sections 3.3.2 to 3.3.5, 3.4.1, 3.4.13 to 3.4.16).
inline std::uint32_t write_channel(Channel& one, unsigned index, std::uint32_t bits) {
    const int number = static_cast<std::int16_t>(bits);
    switch (index) {
        case 0x2000:
            return keep(within(bits, 0U, 1U), one.compensated, bits);
        case 0x4000:
            return keep(within(number, -2730, one.high - 100), one.low, number);
        case 0x4010:
            return keep(within(number, one.low + 100, one.shutdown - 100), one.high, number);
        case 0x4020:
            return keep(within(number, one.high + 100, 17350), one.shutdown, number);
        case 0x4030:
            return keep(within(bits, 0U, 60000U), one.delay_ms, bits);
        case 0x6110:
            return keep(one_of(bits, {1, 2, 4, 5, 6, 7, 9, 10}), one.type, bits);
        case 0x6112:
            return keep(within(bits, 0U, 1U), one.enabled, bits);
        case 0x6126:
            return keep_real(one.factor, bits, 1000.0F);
        default:
            return keep_real(one.offset, bits, 10000.0F);
    }
}

/// Writes a parameter of fault detection (sections 3.4.18 to 3.4.21): FD1 detects high temperature, FD2 high voltage,
/// FD3 low voltage.
inline std::uint32_t write_fault_detection(Application& all, unsigned index, unsigned sub, std::uint32_t bits) {
    auto& set = all.fd_set;
    auto& clear = all.fd_clear;
    switch ((index << 4U) | sub) {
        case 0x50411:
            return keep(within(bits, clear[0], 1250U), set[0], bits);
        case 0x50412:
            return keep(within(bits, clear[1], 1000U), set[1], bits);
        case 0x50413:
            return keep(within(bits, 80U, clear[2]), set[2], bits);
        case 0x50421:
            return keep(within(bits, 500U, set[0]), clear[0], bits);
        case 0x50422:
            return keep(within(bits, clear[2], set[1]), clear[1], bits);
        case 0x50423:
            return keep(within(bits, set[2], clear[1]), clear[2], bits);
        case 0x50501:
        case 0x50502:
            return keep(within(bits, 0U, 1U), all.fd_enabled[sub - 1], bits);
        default:
            return keep(within(bits, 0U, 10000U), all.fd_delay_ms[sub - 1], bits);
    }
}

/// Writes an object from 2000h to 6FFFh.
inline std::uint32_t write_application(Application& all, unsigned index, unsigned sub, std::uint32_t bits) {
    switch (index) {
        case 0x2020:
            return keep(one_of(bits, {50, 60}), all.filter_hz, bits);
        case 0x2112:
            return keep(within(bits, 0U, 1U), all.averages, bits);
        case 0x2126:
            return keep_real(all.average_factor, bits, 1000.0F);
        case 0x2127:
            return keep_real(all.average_offset, bits, 10000.0F);
        case 0x3126:
            return keep_real(all.cj_factor, bits, 1000.0F);
        case 0x3127:
            return keep_real(all.cj_offset, bits, 10000.0F);
        case 0x5555:
            return keep(within(bits, 0U, 2U), all.start, bits);
        case 0x5556:
            return keep(within(bits, 0U, 65000U), all.start_delay_ms, bits);
        default:
            return index >= 0x5000 && index < 0x6000 ? write_fault_detection(all, index, sub, bits)
                                                     : write_channel(all.channel[sub - 1], index, bits);
    }
}

}  // namespace canproof::naive_tcs
