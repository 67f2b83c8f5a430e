// SPDX-License-Identifier: Apache-2.0
// Tests how LSS and 1011h (restore defaults) treat a value of 5B51h (change node-ID) that is not stored (AX130751
// manual, 3.1.2, 3.1.3, 3.2.8, 3.4.88).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using Ax130751LssStorage = Ax130751Test;

TEST_F(Ax130751LssStorage, LssStoreOfABitRateNeitherReplacesNorStoresANodeIdWrittenBySdo) {
    verifies<req::AOR_NODE_009, req::AOR_NODE_012, req::AOR_OD_5B51>();
    EXPECT_EQ(write(0x5B51, 0, 0x32, 1), "");  // 5B51h change node-ID: 32h, not stored
    send("7E5#0401");
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // index 3: 250 kbit/s
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    send("7E5#0400");
    EXPECT_EQ(read(0x5B51, 0), 0x32U) << "LSS does not replace it";
    EXPECT_EQ(power_on(), (Frames{"77F#00"})) << "nor does LSS store it";
}

TEST_F(Ax130751LssStorage, LssStoreReplacesANodeIdSavedBy1010hAndUsedSincePowerOn) {
    verifies<req::AOR_NODE_011, req::AOR_OD_5B51>();
    const auto store_31h_by_lss = [this] {
        send("7E5#0401");
        EXPECT_EQ(send("7E5#1131"), (Frames{"7E4#110000"}));
        EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
        send("7E5#0400");
        node = 0x31;
    };
    store_31h_by_lss();
    EXPECT_EQ(write(0x5B51, 0, 0x32, 1), "");
    store();
    EXPECT_EQ(power_on(), (Frames{"732#00"}));
    store_31h_by_lss();  // LSS has already stored 31h before; the power-on found 32h, saved by 1010h
    EXPECT_EQ(power_on(), (Frames{"731#00"}));
}

TEST_F(Ax130751LssStorage, RestoreParameters1011hDoesNotStoreANodeIdWrittenBySdo) {
    verifies<req::AOR_NODE_002, req::AOR_NODE_004, req::AOR_OD_5B51>();
    for (const int group : {1, 4}) {
        EXPECT_EQ(write(0x5B51, 0, 0x32, 1), "");
        EXPECT_EQ(restore(group), (Frames{fmt::format("5FF#601110{:02X}00000000", group)}));
        EXPECT_EQ(power_on(), (Frames{"77F#00"})) << group;
    }
}

}  // namespace canproof::test
