// SPDX-License-Identifier: Apache-2.0
// Plays a recorded bus to one device in virtual time. The same frames as input always give the same bytes as output.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <vector>

#include "firmware/base/time.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/stimulus.hpp"

namespace canproof::host {

/// Reads the next frame of a log in order of time; returns false at its end.
using FrameSource = std::function<bool(LoggedFrame&)>;

struct ReplayInput {
    std::vector<LoggedFrame> frames;
    std::vector<Stimulus> stimuli;
    std::optional<Instant> until{};                    ///< end of the replay; without it, the time of the last line
    std::optional<Instant> start{};                    ///< time of power-on; without it, see latest_zero
    FrameSource source{};                              ///< replaces `frames`: a log of any length
    std::function<void(const std::string&)> notice{};  ///< receives messages for the user
    std::function<void()> before_call{};  ///< called before a frame, a stimulus or its deadline reaches the device
};

/// Latest first frame of a log whose times count from power-on. Times of a later first frame are those of a clock:
/// replay then starts at this frame.
constexpr Instant latest_zero{3600000000U};
/// Longest silence; a longer one is shortened, because nothing new happens in it.
constexpr Duration longest_silence = milliseconds(3600000);

/// Replays a log; all times are those of the log. After power-on at the start, frames, stimuli and the device's own
/// deadlines follow in order of time. At equal times stimuli precede frames. An overdue event happens at the present
/// time, so time never decreases. Stimuli up to the start precede power-on; frames before the start are left out.
///
/// The device does not receive its own frames. If the log marks the sender of a frame, the device's frames are written
/// in the order and with the times of the log, because waiting frames leave by identifier. Otherwise they are written
/// when the device sends them.
///
/// Writes the device's frames to `frames_out`, and changes of outputs as `seconds,signal,value` to `outputs_out` if
/// that is given. Throws InputError for a signal that the device does not have, and StuckDevice for a device whose
/// deadline does not advance.
void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out);

}  // namespace canproof::host
