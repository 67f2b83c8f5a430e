// SPDX-License-Identifier: Apache-2.0
// One pass of a device's main loop, for a chip on which the firmware has no watchdog and no self-tests.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "target/zynqmp/can.hpp"

namespace canproof::zynqmp {

template <typename Device>
class DeviceLoop {
  public:
    /// Most received frames that one pass processes.
    static constexpr std::uint32_t frames_a_pass = 8U;

    DeviceLoop(Device& device, Can& can) noexcept : device_{device}, can_{can} {}

    /// Runs one pass of the main loop: does each step once. Frames of `queue` go to the controller.
    void pass(TransmitQueue& queue, const Instant now) noexcept {
        if (can_.bit_rate() != device_.bit_rate()) {
            can_.set_bit_rate(device_.bit_rate(), now);
        }
        can_.advance(queue, now);
        Frame frame{};
        bool any{true};
        for (std::uint32_t count = 0U; count < frames_a_pass; ++count) {
            if (any) {
                any = can_.receive(frame);
            }
            if (any) {
                device_.receive(frame, now);
            }
        }
        if (device_.next_deadline() <= now) {
            device_.advance(now);
        }
    }

  private:
    Device& device_;
    Can& can_;
};

}  // namespace canproof::zynqmp
