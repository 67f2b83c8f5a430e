// SPDX-License-Identifier: Apache-2.0
// Inverts a bit of the time from which an AX130751 counts its cycles. The device goes on to run cycles (node 127).
#include <cstring>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/changed_time.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751ChangedTimes : public Ax130751Test {};

}  // namespace

TEST_F(Ax130751ChangedTimes, CyclesRunAgainWhenABitOfTheirFirstTimeHasFlipped) {
    verifies<req::AOR_OUT_053>();
    const Instant start{123'456'000};
    now = start;
    power_on();
    pass(500);
    EXPECT_EQ(device->next_deadline(), never) << "at rest";
    ASSERT_EQ(move_far_ahead(*device, start), 1U);
    inputs.supply = 23.0F;
    set_inputs();
    EXPECT_EQ(device->next_deadline(), now + milliseconds(1));
    pass(1);
    std::uint32_t bits = 0;
    const float volts = 23.0F;
    std::memcpy(&bits, &volts, sizeof bits);
    EXPECT_EQ(read(0x5020, 0), bits) << "5020h (Power Supply Field Value)";
}

}  // namespace canproof::test
