// SPDX-License-Identifier: Apache-2.0
// Tests a node whose description is read at run time: its dictionary answers as the description requires.
#include <gtest/gtest.h>

#include "tests/support/slave_bench.hpp"

namespace canproof::test {

namespace {

class Generic : public testing::Test, public SlaveBench {};

}  // namespace

TEST_F(Generic, DeviceBootsUnderItsNodeId) {
    node_id = 0x21;
    EXPECT_EQ(power_on(), Frames{"721#00"});
}

TEST_F(Generic, EachObjectOfANumberedFamilySuchAsRpdosHasItsOwnDefault) {
    // 1400h:1 RPDO1 COB-ID is 200h + 5, 1402h:1 the invalid 80000400h + 5; 1601h:2 maps the 16 bits of 2100h:2.
    EXPECT_EQ(send("605#4000140100000000"), Frames{"585#4300140105020000"});
    EXPECT_EQ(send("605#4002140100000000"), Frames{"585#4302140105040080"});
    EXPECT_EQ(send("605#4001160200000000"), Frames{"585#4301160210020021"});
}

TEST_F(Generic, LimitsInTheDataSheetAreEnforced) {
    // 2200h accepts -100 … 100; 101 (65h) is too high, -101 (FF9Bh) too low. 2201h accepts 2 and 8 only.
    EXPECT_EQ(send("605#2B00220064000000"), Frames{"585#6000220000000000"});
    EXPECT_EQ(send("605#2B00220065000000"), Frames{"585#8000220031000906"});
    EXPECT_EQ(send("605#2B0022009BFF0000"), Frames{"585#8000220032000906"});
    EXPECT_EQ(send("605#2F01220003000000"), Frames{"585#8001220030000906"});
    EXPECT_EQ(send("605#2F01220008000000"), Frames{"585#6001220000000000"});
}

TEST_F(Generic, ReceivePdoSetsEachMappedObject) {
    send("000#0105");
    send("205#0102");
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200101000000"});
    EXPECT_EQ(send("605#4000200200000000"), Frames{"585#4F00200202000000"});
}

TEST_F(Generic, SavedValueIsKeptOverPowerOn) {
    send("605#2B00220064000000");
    EXPECT_EQ(send("605#2310100173617665"), Frames{"585#6010100100000000"});
    power_on();
    EXPECT_EQ(send("605#4000220000000000"), Frames{"585#4B00220064000000"});
}

}  // namespace canproof::test
