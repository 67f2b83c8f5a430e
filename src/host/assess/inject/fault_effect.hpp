// SPDX-License-Identifier: Apache-2.0
// The effect of an injected fault: what a run with the fault did differently from the run without it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/sim/bus/candump.hpp"

namespace canproof::host {

/// Effects in descending order of precedence: a run with several differences has the first that applies.
enum class FaultEffect : std::uint8_t {
    processor_fault,  ///< detected: an invalid access or instruction stopped the program
    watchdog,         ///< detected: a call did not end, or the deadline did not move
    emergency,        ///< detected: an EMCY message that the run without the fault does not send
    network,          ///< detected: boot-up or a changed state, which the heartbeat consumer sees
    safe_state,       ///< outputs differ, and only by being at their value after power-on
    wrong_output,     ///< silent: an output has another value
    wrong_pdo,        ///< silent: a PDO has other data
    missing_pdo,      ///< a PDO comes at another time, once more or not at all; a consumer's event timer can see this
    wrong_answer,     ///< an SDO or LSS answer, SYNC or another frame differs
    masked,           ///< no difference
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
    std::vector<OutputChange> outputs;  ///< the first changes of each signal are its values after power-on
};

/// Reads what replay() wrote. Throws InputError.
DeviceRun read_run(const std::string& frames, const std::string& outputs);

/// Compares a run that came to its end with the run without a fault. Indicators (LEDs) are outputs as well.
FaultEffect effect_of(const DeviceRun& faultless, const DeviceRun& faulty);

/// Returns the effect's name for tables: `wrong output`.
const char* name_of(FaultEffect effect);
/// Whether the device or the network detects the fault.
bool is_detected(FaultEffect effect);
/// Whether a wrong value leaves the device without a sign of the fault.
bool is_silent(FaultEffect effect);

}  // namespace canproof::host
