// SPDX-License-Identifier: Apache-2.0
// A bus on which a device can send nothing for a while, so that its emergency messages wait.
#pragma once

#include <cstddef>

#include "tests/support/frame_bench.hpp"

namespace canproof::test {

/// A bench with such a bus.
template <typename Bench>
class DisturbedBus : public Bench {
  protected:
    /// Begins the disturbance: the transmit queue is full of frames that have priority over all others.
    void disturb_bus() {
        this->is_blocked = true;
        fill_queue("001#", TransmitQueue::capacity);
    }
    /// Ends the disturbance, when `waiting` frames wait to which the device's emergency messages have priority.
    void free_bus(std::size_t waiting) {
        fill_queue("7FF#", waiting);
        this->is_blocked = false;
    }
    /// Sets the errors of the CAN controller: a lost frame, and error passive.
    void fail_controller(bool fails) {
        this->inputs.can_overrun = fails;
        this->inputs.can_state = fails ? 2 : 0;
    }

  private:
    void fill_queue(const char* frame, std::size_t count) {
        this->queue = TransmitQueue{};
        for (std::size_t i = 0; i < count; ++i) {
            this->queue.push(host::parse_frame(frame, "other traffic"));
        }
    }
};

}  // namespace canproof::test
