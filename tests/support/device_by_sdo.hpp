// SPDX-License-Identifier: Apache-2.0
// A device of the catalogue that a test accesses only by SDO. The test may corrupt the device's non-volatile memory.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "devices/catalogue.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::test {

class DeviceBySdo {
  public:
    DeviceBySdo(const std::string& name, int node_id) : device{host::make_device(name)} { move_to(node_id); }

    void power_cycle() {
        drain();
        device->power_on(Instant{});
        drain();
    }
    /// Gives the device another node-ID, as rotary switches or LSS do, and powers it on.
    void move_to(int node_id) {
        device->set_node_id(node_id);
        power_cycle();
    }
    std::uint32_t read(unsigned index, unsigned sub) {
        const Frame answer = ask(request(0x40, index, sub, 0));
        return answer.data[0] == 0x80 ? 0xDEADBEEFU : read_u32(answer.payload(), 4);
    }
    /// Writes `size` bytes of `value`. Returns whether the device confirmed the SDO download.
    bool write(unsigned index, unsigned sub, unsigned size, std::uint32_t value) {
        return ask(request(0x23U | ((4U - size) << 2U), index, sub, value)).data[0] == 0x60;
    }
    bool save(unsigned sub = 1) { return write(0x1010, sub, 4, 0x65766173); }

    std::unique_ptr<host::SimulatedDevice> device;

  private:
    Frame request(unsigned command, unsigned index, unsigned sub, std::uint32_t value) const {
        Frame frame = data_frame(0x600U + device->node_id(), 8);
        frame.data[0] = static_cast<std::uint8_t>(command);
        write_le(MutableBytes{frame.data}, 1, 2, index);
        frame.data[3] = static_cast<std::uint8_t>(sub);
        write_le(MutableBytes{frame.data}, 4, 4, value);
        return frame;
    }
    /// Sends an SDO request. Returns the SDO answer, or an empty frame when the device does not answer.
    Frame ask(const Frame& frame) {
        drain();
        device->receive(frame, Instant{});
        Frame answer{};
        while (!device->queue().empty()) {
            const Frame sent = device->queue().pop();
            if (sent.id == 0x580U + device->node_id()) {
                answer = sent;
            }
        }
        return answer;
    }
    void drain() {
        while (!device->queue().empty()) {
            device->queue().pop();
        }
    }
};

}  // namespace canproof::test
