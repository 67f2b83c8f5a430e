// A recorded bus played to one device in virtual time: the same frames in, the same bytes out, every time.
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

/// The next frame of a log in order of time; false at its end.
using FrameSource = std::function<bool(LoggedFrame&)>;

struct ReplayInput {
    std::vector<LoggedFrame> frames;
    std::vector<Stimulus> stimuli;
    std::optional<Instant> until{};                    ///< else the time of the last line
    std::optional<Instant> start{};                    ///< power-on; else as latest_zero says
    FrameSource source{};                              ///< instead of `frames`: a log of any length
    std::function<void(const std::string&)> notice{};  ///< what the user should know
};

/// A log whose first frame is later counts from no power-on, but by the clock: replay begins at its first frame.
constexpr Instant latest_zero{3600000000U};
/// A longer silence is shortened to this: a device does nothing new in it.
constexpr Duration longest_silence = milliseconds(3600000);

/// All times are the log's. Power-on at the start, then frames, stimuli and the device's own deadlines in order of
/// time; at equal times stimuli come before frames, and what was due earlier is done now: time never goes back. Stimuli
/// up to the start come before power-on, frames before it are left out.
///
/// Frames that the device has sent itself are not fed to it. Where the log marks who has sent a frame, what a device
/// sent is written in the log's order and with its times: frames that wait for the bus leave it by identifier.
/// Otherwise they are written when the device makes them.
///
/// Writes the device's frames to `frames_out`, changes of outputs as `seconds,signal,value` to `outputs_out` when
/// given. Throws InputError for a signal that the device does not have, StuckDevice for a device that does not do what
/// is due.
void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out);

}  // namespace canproof::host
