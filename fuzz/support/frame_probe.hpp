// SPDX-License-Identifier: Apache-2.0
// Lets a program that replays a corpus measure the work for each frame, or log the frames. Fuzz targets call the probe
// before and after each frame that they give to a device. Without a listener, the probe does nothing.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::fuzz {

struct FrameProbe {
    void (*begins)(const Frame& frame, Instant now){nullptr};
    void (*ends)(const Frame& frame){nullptr};
    Instant start{};          ///< time at which the input began
    Instant deadline{never};  ///< the device's next deadline before the frame
    /// Called with each frame that a received frame makes the device send at once. Only DeviceWorld calls it.
    void (*answers)(const Frame& frame){nullptr};
};

inline FrameProbe frame_probe;

/// Returns the time at which an input begins: 300 ms before the number of microseconds exceeds 32 bits. This reveals
/// code that stores a time in 32 bits, in each input that lasts longer than 300 ms.
inline Instant begin_input() {
    frame_probe.start = Instant{(std::uint64_t{1} << 32U) - 300'000U};
    return frame_probe.start;
}

/// Gives one frame to a device and informs the probe.
template <typename Device>
void deliver(Device& device, const Frame& frame, Instant now) {
    if (frame_probe.begins != nullptr) {
        frame_probe.deadline = device.next_deadline();
        frame_probe.begins(frame, now);
    }
    device.receive(frame, now);
    if (frame_probe.ends != nullptr) {
        frame_probe.ends(frame);
    }
}

}  // namespace canproof::fuzz
