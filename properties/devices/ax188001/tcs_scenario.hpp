// SPDX-License-Identifier: Apache-2.0
// Actions that a property performs on an AX188001: changes of its parameters, its terminals and the time. A generator
// makes them from random numbers. TcsRig is the device on which they are performed.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <utility>

#include "properties/devices/ax188001/naive_thermocouple.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"

namespace canproof::test {

/// One action, and the time that passes after it.
struct TcsAction {
    enum Kind { heat, wire, voltage, cold_junction, cpu, supply, hum, overrun, can, write, command, power_cycle };
    Kind kind{heat};
    int channel{1};     ///< the channel, if the action concerns one (heat, wire, voltage or hum)
    double value{0.0};  ///< in degC, uV or V; 0 or 1 for wire and overrun; the specifier of a command
    int index{0};       ///< index of a write
    int sub{0};         ///< sub-index of a write, node-ID of a command, or mains frequency of a hum (0: 50 Hz, 1: 60
                        ///< Hz)
    int size{1};        ///< length of a write in bytes
    std::uint32_t bits{0};
    std::uint64_t wait_ms{0};
};

inline std::ostream& operator<<(std::ostream& out, const TcsAction& action) {
    static constexpr std::array<const char*, 12> names{"heat",      "wire",   "voltage", "cold junction",
                                                       "cpu",       "supply", "hum",     "overrun",
                                                       "CAN state", "write",  "command", "power cycle"};
    out << names[action.kind];
    if (action.kind == TcsAction::write) {
        out << fmt::format(" {:04X}h:{} = {:X}h", action.index, action.sub, action.bits);
    } else {
        out << " channel " << action.channel << " value " << action.value << " node " << action.sub;
    }
    return out << ", then " << action.wait_ms << " ms";
}

inline TcsAction written(int index, int sub, int size, std::uint32_t bits, std::uint64_t wait_ms = 0) {
    TcsAction action;
    action.kind = TcsAction::write;
    action.index = index;
    action.sub = sub;
    action.size = size;
    action.bits = bits;
    action.wait_ms = wait_ms;
    return action;
}
inline TcsAction written_real(int index, int sub, float value, std::uint64_t wait_ms = 0) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return written(index, sub, 4, bits, wait_ms);
}

/// Returns the terminal voltage in uV of a thermocouple at `celsius`. The thermocouple has the type that is set for the
/// channel.
inline float terminal_uv(const TcsBench& bench, int channel, double celsius) {
    const auto type = static_cast<unsigned>(bench.device->objects().read(0x6110, static_cast<std::uint8_t>(channel)));
    const bool compensated = bench.device->objects().read(0x2000, static_cast<std::uint8_t>(channel)) != 0;
    const double cold_uv = naive_tcs::uv_of(type, static_cast<double>(bench.inputs.cold_junction));
    return static_cast<float>(naive_tcs::uv_of(type, celsius) - (compensated ? cold_uv : 0.0));
}

/// Performs an action that changes the terminals: sets the inputs of the bench.
inline void put_inputs(TcsBench& bench, const TcsAction& action) {
    const auto at = static_cast<std::size_t>(action.channel - 1);
    const auto value = static_cast<float>(action.value);
    switch (action.kind) {
        case TcsAction::heat:
            bench.inputs.tc_microvolts[at] = terminal_uv(bench, action.channel, action.value);
            break;
        case TcsAction::wire:
            bench.inputs.tc_open[at] = action.value > 0;
            break;
        case TcsAction::voltage:
            bench.inputs.tc_microvolts[at] = value;
            break;
        case TcsAction::cold_junction:
            bench.inputs.cold_junction = value;
            break;
        case TcsAction::cpu:
            bench.inputs.cpu_temperature = value;
            break;
        case TcsAction::supply:
            bench.inputs.supply = value;
            break;
        case TcsAction::hum:
            bench.inputs.tc_hum[at] = value;
            bench.inputs.mains_frequency = action.sub == 0 ? 50 : 60;
            break;
        case TcsAction::overrun:
            bench.inputs.can_overrun = action.value > 0;
            break;
        case TcsAction::can:
            bench.inputs.can_state = static_cast<std::uint8_t>(action.value);
            break;
        case TcsAction::write:
        case TcsAction::command:
        case TcsAction::power_cycle:
        default:
            break;
    }
}

/// Returns the frame of a write or a command.
inline std::string frame_of(const TcsAction& action) {
    if (action.kind == TcsAction::command) {
        return fmt::format("000#{:02X}{:02X}", static_cast<int>(action.value), action.sub);
    }
    return fmt::format("67F#{:02X}{:02X}{:02X}{:02X}{}", 0x23 | ((4 - action.size) << 2), action.index & 0xFF,
                       action.index >> 8, action.sub, TcsBench::little_endian(action.bits));
}

using TimedFrames = std::vector<std::pair<std::uint64_t, std::string>>;

/// The device, its clock, and all frames that it has sent.
class TcsRig {
  public:
    TcsRig() { note(bench.power_on()); }

    void happen(const TcsAction& action) {
        if (action.kind == TcsAction::write || action.kind == TcsAction::command) {
            note(bench.send(frame_of(action)));
        } else if (action.kind == TcsAction::power_cycle) {
            note(bench.power_on());
        } else {
            put_inputs(bench, action);
            note(bench.set_inputs());
        }
    }
    /// Advances the time to the next deadline of the device, or to `end_ms` if that is earlier.
    void go_on(std::uint64_t end_ms) {
        const Instant end = Instant{} + milliseconds(end_ms);
        const Instant next = earliest(bench.device->next_deadline(), end);
        bench.now = next < bench.now ? bench.now : next;
        if (bench.device->next_deadline() <= bench.now) {
            bench.device->advance(bench.now);
            note(bench.sent());
            RC_ASSERT(bench.device->next_deadline() > bench.now);  // the device has done all work that was due
        }
    }
    std::uint64_t now_ms() const { return bench.now.us / 1000; }
    bool is_due() const { return bench.device->next_deadline() <= bench.now; }
    TimedFrames take() { return std::exchange(seen_, {}); }

    TcsBench bench;

  private:
    void note(const Frames& frames) {
        for (const auto& frame : frames) {
            seen_.emplace_back(now_ms(), frame);
        }
    }

    TimedFrames seen_;
};

/// Performs an action, then lets the time `wait_ms` of the action pass.
inline void play(TcsRig& rig, const TcsAction& action) {
    rig.happen(action);
    for (const std::uint64_t end = rig.now_ms() + action.wait_ms; rig.now_ms() < end || rig.is_due();) {
        rig.go_on(end);
    }
}

/// Random numbers from which a generator makes actions, four for each action.
using TcsNumbers = std::vector<std::array<unsigned, 4>>;

}  // namespace canproof::test
