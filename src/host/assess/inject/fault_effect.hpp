// SPDX-License-Identifier: Apache-2.0
// The effect of an injected fault: how the run with the fault differs from the run without it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/sim/bus/candump.hpp"

namespace canproof::host {

/// The effects in descending order of precedence. A run with several differences gets the first effect that applies.
enum class FaultEffect : std::uint8_t {
    processor_fault,  ///< detected: an invalid access or instruction stopped the program
    watchdog,         ///< detected: a call of the device did not end, or its next deadline stayed the same
    emergency,        ///< detected: the device sends an EMCY message that the run without the fault does not contain
    network,          ///< detected: a boot-up message, heartbeat or guarding answer is changed, missing, extra or late
    safe_state,       ///< outputs differ from the run without the fault, but only because they have their value after
                      ///< power-on
    wrong_output,     ///< silent: an output has a wrong value
    wrong_pdo,        ///< silent: a PDO contains wrong data
    /// a PDO comes at another time, additionally or not at all; the event timer of a consumer can detect this
    missing_pdo,
    wrong_answer,  ///< an SDO or LSS answer, a SYNC or another frame differs
    masked,        ///< there is no difference
};
constexpr std::size_t fault_effects = 10;

struct OutputChange {
    std::string time;  ///< in seconds, as replay writes it
    std::string signal;
    std::string value;
    friend bool operator==(const OutputChange& a, const OutputChange& b) {
        return a.time == b.time && a.signal == b.signal && a.value == b.value;
    }
};

/// The frames and output changes of one run.
struct DeviceRun {
    std::vector<LoggedFrame> frames;
    std::vector<OutputChange> outputs;  ///< the first change of each signal is its value after power-on
};

/// Parses the two texts that replay() writes. Throws InputError when they do not have the form of these texts.
DeviceRun read_run(const std::string& frames, const std::string& outputs);

/// Compares the completed run of a device with a fault to the run of the same device without a fault. Counts indicators
/// (LEDs) as outputs.
FaultEffect effect_of(const DeviceRun& faultless, const DeviceRun& faulty);

/// Returns the effect's name for tables: `wrong output`.
const char* name_of(FaultEffect effect);
/// Returns whether the device or the network detects a fault with this effect.
bool is_detected(FaultEffect effect);
/// Returns whether a fault with this effect is silent: a wrong value leaves the device, and nothing reports the fault.
bool is_silent(FaultEffect effect);

}  // namespace canproof::host
