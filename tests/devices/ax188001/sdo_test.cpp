// SPDX-License-Identifier: Apache-2.0
// Tests that an AX188001 watches the time of an SDO transfer beside its readings, node 127.
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Sdo = TcsTest;

}  // namespace

TEST_F(Ax188001Sdo, SegmentedDownloadThatStallsForASecondIsAborted) {
    verifies<req::CO_SDO_014>();
    pass(10);  // the time-out, 1010 ms, is between the readings at 990 and 1155 ms
    // a client begins to write 1017h (producer heartbeat time), but sends no segment
    EXPECT_EQ(send("67F#2117100002000000"), (Frames{"5FF#6017100000000000"}));
    EXPECT_EQ(pass(999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:5FF#8017100000000405"}));
    EXPECT_EQ(pass(3000), Frames{});
}

}  // namespace canproof::test
