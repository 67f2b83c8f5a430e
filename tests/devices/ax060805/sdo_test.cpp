// SPDX-License-Identifier: Apache-2.0
// Tests that an AX060805 watches the time of an SDO transfer beside its samples, node 127.
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax060805Sdo = InclinometerTest;

}  // namespace

TEST_F(Ax060805Sdo, SegmentedDownloadThatStallsForASecondIsAborted) {
    verifies<req::CO_SDO_014>();
    pass(2);  // the time-out, 1002 ms, is between the samples at 1000 and 1005 ms
    // a client begins to write 1017h (producer heartbeat time), but sends no segment
    EXPECT_EQ(send("67F#2117100002000000"), (Frames{"5FF#6017100000000000"}));
    EXPECT_EQ(pass(999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:5FF#8017100000000405"}));
    EXPECT_EQ(pass(3000), Frames{});
}

}  // namespace canproof::test
