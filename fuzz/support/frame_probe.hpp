// Lets a program that replays a corpus measure the work for each frame, or write the frames down. Fuzz targets call it
// around every frame that they give to a device; without anyone listening it does nothing.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::fuzz {

struct FrameProbe {
    void (*begins)(const Frame& frame, Instant now){nullptr};
    void (*ends)(const Frame& frame){nullptr};
};

inline FrameProbe frame_probe;

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
