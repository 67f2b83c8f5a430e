// Lets a program that replays a corpus measure the work for each frame, or write the frames down. Fuzz targets call it
// around every frame that they give to a device; without anyone listening it does nothing.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::fuzz {

struct FrameProbe {
    void (*begins)(const Frame& frame, Instant now){nullptr};
    void (*ends)(const Frame& frame){nullptr};
    Instant start{};  ///< when the input began
    /// What the device sends because of that frame.
    void (*answers)(const Frame& frame){nullptr};
};

inline FrameProbe frame_probe;

/// The time at which an input begins: 300 ms before 32 bits of microseconds are full, so that whatever keeps a time in
/// fewer bits than Instant does is late or early within any input.
inline Instant begin_input() {
    frame_probe.start = Instant{(std::uint64_t{1} << 32U) - 300'000U};
    return frame_probe.start;
}

/// Gives one frame to a device under the eyes of the probe.
template <typename Device>
void deliver(Device& device, const Frame& frame, Instant now) {
    if (frame_probe.begins != nullptr) {
        frame_probe.begins(frame, now);
    }
    device.receive(frame, now);
    if (frame_probe.ends != nullptr) {
        frame_probe.ends(frame);
    }
}

}  // namespace canproof::fuzz
