// SPDX-License-Identifier: Apache-2.0
// Simulates many AX130751 in virtual time, each from deadline to deadline, to measure the processor time of such a
// simulation.
#pragma once

#include <memory>
#include <vector>

#include "devices/catalogue.hpp"

namespace canproof::bench {

/// Devices with default parameters. Their node-IDs are 1 to 127, then 1 to 127 again, and so on: they are not connected
/// by a bus, which could have at most 127 nodes.
class Fleet {
  public:
    explicit Fleet(std::size_t size, bool operational = true) {
        for (std::size_t i = 0; i < size; ++i) {
            devices_.push_back(host::make_device("ax130751"));
            devices_.back()->set_node_id(static_cast<int>(i % 127) + 1);
            devices_.back()->power_on(now_);
        }
        if (operational) {
            Frame start = data_frame(0x000, 2);  // NMT command "start" to all nodes
            start.data[0] = 0x01;
            receive(start);
        }
    }

    void receive(const Frame& frame) {
        for (const auto& device : devices_) {
            device->receive(frame, now_);
        }
    }
    /// Runs every device for `length`, from deadline to deadline. Returns the number of frames sent in that time.
    std::size_t run(Duration length) {
        const Instant end = now_ + length;
        std::size_t frames = 0;
        for (const auto& device : devices_) {
            while (device->next_deadline() <= end) {
                device->advance(device->next_deadline());
                for (; !device->queue().empty(); ++frames) {
                    device->queue().pop();
                }
            }
        }
        now_ = end;
        return frames;
    }
    host::SimulatedDevice& device(std::size_t at) { return *devices_[at]; }
    Instant now() const { return now_; }

  private:
    std::vector<std::unique_ptr<host::SimulatedDevice>> devices_;
    Instant now_{};
};

}  // namespace canproof::bench
