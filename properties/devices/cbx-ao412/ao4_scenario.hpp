// SPDX-License-Identifier: Apache-2.0
// Actions that a property performs on a CAN-CBX-AO412. A generator makes them from random numbers.
#pragma once

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <vector>

#include "tests/devices/cbx-ao412/bench.hpp"

namespace canproof::test {

/// One action, and the time that passes after it.
struct Ao4Action {
    enum Kind { write, frame, remote, terminal, power_cycle };
    Kind kind{write};
    unsigned id{0};              ///< identifier of a frame or remote frame; if `own` is true, without the node-ID
    bool own{false};             ///< whether the node-ID of the device is added to `id`
    std::vector<unsigned> data;  ///< data of a frame
    unsigned index{0};           ///< index of a write, or number of a terminal
    unsigned sub{0};             ///< sub-index of a write
    unsigned size{1};            ///< length of a write in bytes
    std::uint32_t value{0};      ///< value of a write, or of a terminal
    std::uint64_t wait_ms{0};
};

inline std::ostream& operator<<(std::ostream& out, const Ao4Action& action) {
    static constexpr std::array<const char*, 5> names{"write", "frame", "remote", "terminal", "power cycle"};
    return out << fmt::format("{} {:X}h:{} = {:X}h, id {:X}h, then {} ms", names[action.kind], action.index, action.sub,
                              action.value, action.id, action.wait_ms);
}

inline Ao4Action ao4_write(unsigned index, unsigned sub, unsigned size, std::uint32_t value) {
    Ao4Action action;
    action.index = index;
    action.sub = sub;
    action.size = size;
    action.value = value;
    return action;
}
inline Ao4Action ao4_frame(unsigned id, bool own, const std::vector<unsigned>& data) {
    Ao4Action action;
    action.kind = Ao4Action::frame;
    action.id = id;
    action.own = own;
    action.data = data;
    return action;
}
inline Ao4Action ao4_terminal(unsigned number, std::uint32_t value) {
    Ao4Action action;
    action.kind = Ao4Action::terminal;
    action.index = number;
    action.value = value;
    return action;
}

inline std::vector<unsigned> little_endian_bytes(std::uint32_t value, unsigned count) {
    std::vector<unsigned> bytes;
    for (unsigned i = 0; i < count; ++i) {
        bytes.push_back((value >> (8U * i)) & 0xFFU);
    }
    return bytes;
}

/// A frame on the bus: identifier, data, and whether it is a remote frame.
struct Ao4Frame {
    unsigned id;
    std::vector<unsigned> data;
    bool remote;

    std::string text() const {
        std::string text = fmt::format("{:03X}#", id);
        for (const unsigned one : data) {
            text += fmt::format("{:02X}", one);
        }
        return remote ? text + "R" : text;
    }
};

inline Ao4Frame frame_of(const Ao4Action& action, unsigned node) {
    if (action.kind == Ao4Action::write) {
        std::vector<unsigned> data{0x23U | ((4U - action.size) << 2U), action.index & 0xFFU, action.index >> 8U,
                                   action.sub};
        for (const unsigned one : little_endian_bytes(action.value, 4)) {
            data.push_back(one);
        }
        return {0x600 + node, data, false};
    }
    return {action.id + (action.own ? node : 0U), action.data, action.kind == Ao4Action::remote};
}

/// Sets a terminal by number: switches High, Low and Baud, CAN state, lost frames, software failure, hardware failure.
inline void put_terminal(cbx_ao412::Inputs& inputs, unsigned number, std::uint32_t value) {
    const auto octet = static_cast<std::uint8_t>(value);
    switch (number) {
        case 0:
            inputs.switch_high = octet;
            break;
        case 1:
            inputs.switch_low = octet;
            break;
        case 2:
            inputs.switch_baud = octet;
            break;
        case 3:
            inputs.can_state = octet;
            break;
        case 4:
            inputs.can_overrun = value != 0;
            break;
        case 5:
            inputs.internal_fault = value != 0;
            break;
        default:
            inputs.hardware_fault = value != 0;
            break;
    }
}

using Ao4Numbers = std::array<unsigned, 4>;

/// Returns a write of a parameter: `which` chooses the object, `number` the sub-index and the value.
inline Ao4Action ao4_write_of(unsigned which, unsigned number) {
    const unsigned sub = 1 + number % 4;
    const unsigned rest = number / 4;
    switch (which % 18) {
        case 0:
        case 1:
        case 2:
            return ao4_write(0x6411, sub, 2, rest % 5 == 0 ? rest % 17 - 8U : rest * 7U);
        case 3:
        case 4:
            return ao4_write(0x6443, sub, 1, rest % 4);
        case 5:
            return ao4_write(0x6444, sub, 4, rest * 40503U * 65536U + rest);
        case 6:
            return ao4_write(0x2404, sub, 2, rest % 3 == 0 ? 0 : rest % 400 - 200U);
        case 7:
            return ao4_write(0x2405, sub, 2, rest % 3 == 0 ? 0 : rest * 31U);
        case 8:
            return ao4_write(0x1016, 1, 4, rest % 4 == 0 ? 0 : ((0x31U + rest % 2) << 16U) | (50 + rest % 600));
        case 9:
            return ao4_write(0x1017, 0, 2, rest % 3 == 0 ? 0 : 40 + rest % 900);
        case 10:
            return ao4_write(0x100C, 0, 2, rest % 5 == 0 ? 0 : 50 + rest % 300);
        case 11:
            return ao4_write(0x100D, 0, 1, rest % 4);
        case 12:
            return ao4_write(0x1015, 0, 2, rest % 2 == 0 ? 0 : 10 * (rest % 150));
        case 13:
            return ao4_write(0x1029, 1, 1, rest % 4);
        case 14: {
            constexpr std::array<unsigned, 4> types{255, 254, 0, 240};
            return ao4_write(0x1401, 2, 1, types[rest % 4]);
        }
        case 15:
            return rest % 2 == 0 ? ao4_write(0x1F80, 0, 4, rest % 5 == 0 ? 4 : 8)
                                 : ao4_write(0x1F91, 1, 2, 1 + rest % 700);
        case 16:
            return ao4_write(0x1003, 0, 1, rest % 4 == 0 ? 1 : 0);
        default:
            return rest % 5 == 0 ? ao4_write(0x1011, 1, 4, 0x64616F6C) : ao4_write(0x1010, 1, 4, 0x65766173);
    }
}

inline Ao4Action ao4_action_of(const Ao4Numbers& numbers) {
    const unsigned number = numbers[1];
    Ao4Action action;
    switch (numbers[0] % 22) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
            action = ao4_write_of(numbers[2], number);
            break;
        case 5:
        case 6: {
            std::vector<unsigned> data;
            for (unsigned i = 0; i < (number % 11 == 0 ? 6U : 8U); ++i) {
                data.push_back((number * (i + 3U) * 2654435761U >> 8U) & 0xFFU);
            }
            action = ao4_frame(0x300, true, data);
            break;
        }
        case 7:
        case 20: {
            constexpr std::array<unsigned, 8> commands{0x01, 0x01, 0x81, 0x02, 0x80, 0x81, 0x82, 0x05};
            constexpr std::array<unsigned, 3> other{5, 6, 7};
            action = ao4_frame(0, false, {commands[number % 8], 0});
            if (numbers[2] % 6 == 0) {
                action.data[1] = 120 + other[number % 3];
            }
            break;
        }
        case 8:
            action = ao4_frame(0x080, false, std::vector<unsigned>(number % 5 == 0 ? 1 : 0));
            break;
        case 9:
        case 16:
        case 17:
            action = ao4_frame(0x731 + (number % 5 == 0 ? 1U : 0U), false, {5});
            break;
        case 10:
            action.kind = Ao4Action::remote;
            action.id = number % 4 == 0 ? 0x300 : 0x700;
            action.own = true;
            break;
        case 11:
        case 12:
            action = ao4_terminal(3, number % 4);
            break;
        case 13:
        case 18:
        case 19:
            action = ao4_terminal(4 + number % 3, number / 3 % 2);
            break;
        case 14:
            action = ao4_terminal(number % 3, number / 3 % (number % 3 == 0 ? 9 : 16));
            break;
        default:
            action.kind = Ao4Action::power_cycle;
            break;
    }
    const unsigned wait = numbers[3] / 4;
    constexpr std::array<unsigned, 4> longest{1, 12, 400, 1700};
    action.wait_ms = wait % longest[numbers[3] % 4];
    return action;
}

}  // namespace canproof::test
