// SPDX-License-Identifier: Apache-2.0
// Plays a recorded bus to one device in virtual time. The same input always gives the same output, byte for byte.
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

/// A function that reads the next frame of a log, in order of time. Returns false at the end of the log.
using FrameSource = std::function<bool(LoggedFrame&)>;

struct ReplayInput {
    std::vector<LoggedFrame> frames;
    std::vector<Stimulus> stimuli;
    std::optional<Instant> until{};  ///< end of the replay; without it, the time of the last frame or stimulus
    std::optional<Instant> start{};  ///< time of power-on; without it, 0 or the first frame (see latest_zero)
    FrameSource source{};            ///< source of the frames in place of `frames`, for a log of any length
    std::function<void(const std::string&)> notice{};  ///< receives messages for the user
    /// called before each call of the device: for a frame, a stimulus or a deadline
    std::function<void()> before_call{};
};

/// If the first frame of a log is not later than this, the times of the log count from power-on. If it is later, they
/// are times of a clock, and the replay starts at the first frame.
constexpr Instant latest_zero{3600000000U};
/// Longest silence. A longer silence is shortened, because nothing new happens in it.
constexpr Duration longest_silence = milliseconds(3600000);

/// Replays a log. All times are those of the log.
///
/// After power-on at the start, frames, stimuli and the device's own deadlines follow in order of time. At the same
/// time, stimuli come before frames. An overdue event happens at the present time, so time never decreases. Stimuli up
/// to the start are applied before power-on; frames before the start are left out.
///
/// The device does not receive its own frames. If the lines of the log end with T or R, which tells the sender of each
/// frame, the device's frames are written in the order and with the times of the log. (On a bus, waiting frames are
/// sent in the order of their identifiers.) Otherwise they are written when the device sends them.
///
/// Writes the device's frames to `frames_out` and, unless it is nullptr, changes of outputs as `seconds,signal,value`
/// to `outputs_out`. Throws InputError for a signal that the device does not have, and for an end before the start.
/// Throws StuckDevice for a device whose deadline does not advance.
void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out);

}  // namespace canproof::host
