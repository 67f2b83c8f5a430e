// SPDX-License-Identifier: Apache-2.0
// Tests in all devices that an emergency message that waits when bus-off begins is sent after it (CiA 301, 7.2.7).
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/device_by_sdo.hpp"
#include "tests/support/every_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// In each device, a missing heartbeat of node 9 is error 8130h.
TEST(EveryDevice, EmcyThatWaitsWhenBusOffBeginsIsSentAfterTheBusOff) {
    verifies<req::CO_EMCY_035>();
    for (const std::string& name : every_device()) {
        DeviceBySdo unit{name, 5};
        ASSERT_TRUE(unit.write(0x1016, 1, 4, 0x00090064)) << name;  // heartbeats of node 9 at least every 100 ms
        Frame heartbeat = data_frame(0x709, 1);
        heartbeat.data[0] = 0x05;
        unit.device->receive(heartbeat, Instant{});
        const Instant missing{100001};
        unit.device->advance(missing);
        unit.device->set_input("can_state", 3, missing);
        EXPECT_TRUE(unit.device->queue().empty()) << name;
        unit.device->set_input("can_state", 0, missing);
        int count = 0;
        while (!unit.device->queue().empty()) {
            const Frame frame = unit.device->queue().pop();
            count += frame.id == 0x085 && frame.data[0] == 0x30 && frame.data[1] == 0x81 ? 1 : 0;
        }
        EXPECT_EQ(count, 1) << name;
    }
}

}  // namespace canproof::test
