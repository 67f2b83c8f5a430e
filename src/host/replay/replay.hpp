// A recorded bus played to one device in virtual time: the same frames in, the same bytes out, every time.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "host/bus/candump.hpp"
#include "host/devices/simulated_device.hpp"
#include "host/replay/stimulus.hpp"

namespace canproof::host {

struct ReplayInput {
    std::vector<LoggedFrame> frames;
    std::vector<Stimulus> stimuli;
    std::optional<Instant> until;  ///< else the time of the last line
};

/// Power-on at 0, then frames, stimuli and the device's own deadlines in order of time; at equal times stimuli come
/// before frames. Frames marked as transmitted that this device has sent itself are not fed to it. Writes the device's
/// frames to `frames_out`, changes of outputs as `seconds,signal,value` to `outputs_out` when given. Throws InputError
/// for a signal that the device does not have.
void replay(SimulatedDevice& device, const ReplayInput& input, std::ostream& frames_out, std::ostream* outputs_out);

}  // namespace canproof::host
