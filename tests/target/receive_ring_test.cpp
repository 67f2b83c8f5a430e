// SPDX-License-Identifier: Apache-2.0
// The ring buffer between the receive interrupt and the main loop.
#include "target/stm32f405/receive_ring.hpp"

#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// The ring has 32 places. After each number of popped frames, it takes 32 more and reports only the loss of a 33rd.
TEST(ReceiveRing, RingTakes32FramesWhereverTheFirstOneLies) {
    verifies<req::CO_CAN_004, req::CO_CAN_005>();
    stm32f405::ReceiveRing ring;
    Frame got{};
    for (std::uint32_t turn = 0; turn < 70; ++turn) {
        ASSERT_FALSE(ring.pop(got));
        for (std::uint32_t id = 0; id < 32; ++id) {
            ring.push(data_frame(100 * turn + id, 0));
        }
        ASSERT_FALSE(ring.take_overrun()) << turn;
        ring.push(data_frame(0x7FF, 0));
        ASSERT_TRUE(ring.take_overrun()) << turn;
        ASSERT_FALSE(ring.take_overrun()) << turn;
        for (std::uint32_t id = 0; id < 32; ++id) {
            ASSERT_TRUE(ring.pop(got));
            ASSERT_EQ(got.id, 100 * turn + id);
        }
        ring.push(data_frame(turn, 0));  // moves the place of the first frame by one
        ASSERT_TRUE(ring.pop(got));
        ASSERT_EQ(got.id, turn);
    }
    EXPECT_FALSE(ring.take_overrun());
}

}  // namespace canproof::test
