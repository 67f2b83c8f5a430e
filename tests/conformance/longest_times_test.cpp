// SPDX-License-Identifier: Apache-2.0
// Tests each time that can be set in a node with its greatest value (CiA 301, 7.5.2). If the node lost a high bit of
// this value, the time would be too short.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/tpdo_cases.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/rpdo_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The fixture for a CAN-CBX-AO412 as node 3.
using LongestTimes = CbxTest;
/// The fixtures for the conformance slave as node 5.
using LongestTimesOfTpdos = Tpdo;
using LongestTimesOfRpdos = Rpdo;

constexpr std::uint64_t longest_ms = 65535;  // the greatest UNSIGNED16

}  // namespace

TEST_F(LongestTimes, LongestHeartbeatPeriodIs65535Milliseconds) {
    verifies<req::CO_HB_001>();
    write("603#2B171000FFFF0000");  // 1017h producer heartbeat time: 65,535 ms
    EXPECT_TRUE(pass(longest_ms - 1).empty());
    EXPECT_EQ(pass(1), (Frames{"1:703#7F"}));
    EXPECT_EQ(pass(longest_ms), (Frames{"65535:703#7F"}));
}

TEST_F(LongestTimes, LongestConsumerHeartbeatTimeIs65535Milliseconds) {
    verifies<req::CO_HB_002, req::CO_HB_004>();
    write("603#23161001FFFF3100");  // 1016h:1 consumer heartbeat time: node 31h, 65,535 ms
    send("731#05");
    EXPECT_TRUE(pass(longest_ms - 1).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
}

TEST_F(LongestTimes, LongestLifeTimeIs255Times65535Milliseconds) {
    verifies<req::CO_GUARD_007>();
    write("603#2B0C1000FFFF0000");  // 100Ch guard time: 65,535 ms
    write("603#2F0D1000FF000000");  // 100Dh life time factor: 255
    EXPECT_EQ(send("703#R1"), (Frames{"703#7F"}));
    constexpr std::uint64_t life_ms = 255 * longest_ms;  // life time: 16,711,425 ms, more than four and a half hours
    EXPECT_TRUE(pass(life_ms - 1).empty());
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"}));
}

TEST_F(LongestTimes, LongestEmcyInhibitTimeIs6553500Microseconds) {
    verifies<req::CO_EMCY_003>();
    write("603#2B151000FFFF0000");  // 1015h inhibit time EMCY: 65,535 * 100 us
    inputs.can_overrun = true;
    EXPECT_EQ(set_inputs(), (Frames{"083#1081110100000000"}));
    inputs.can_overrun = false;
    EXPECT_TRUE(set_inputs().empty());
    EXPECT_TRUE(pass(6553).empty());
    now = now + microseconds(499);
    device->advance(now);
    EXPECT_TRUE(sent().empty());
    now = now + microseconds(1);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"083#0000000100000000"}));
}

TEST_F(LongestTimes, LongestSyncPeriodIs4294967295Microseconds) {
    verifies<req::CO_SYNC_003>();
    write("603#2305100080000040");  // 1005h COB-ID SYNC: producer
    write("603#23061000FFFFFFFF");  // 1006h communication cycle period: 2^32 - 1 us, 71 minutes
    for (int period = 1; period <= 2; ++period) {
        now = now + microseconds(4294967294U);
        device->advance(now);
        EXPECT_TRUE(sent().empty());
        now = now + microseconds(1);
        device->advance(now);
        EXPECT_EQ(sent(), (Frames{"080#"}));
    }
}

TEST_F(LongestTimesOfTpdos, LongestTpdoEventTimerIs65535Milliseconds) {
    verifies<req::CO_PDO_047>();
    send("605#2B001805FFFF0000");  // 1800h:5 event timer of TPDO1: 65,535 ms
    start();
    EXPECT_TRUE(pass(longest_ms - 1).empty());
    EXPECT_EQ(pass(1), (Frames{"1:185#0000"}));
}

TEST_F(LongestTimesOfTpdos, LongestTpdoInhibitTimeIs6553500Microseconds) {
    verifies<req::CO_PDO_017>();
    set_inhibit_time("FFFF");  // 1800h:3 inhibit time of TPDO1: 65,535 * 100 us
    start();
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"585#6001200100000000"}));
    EXPECT_TRUE(pass(6553).empty());
    now = now + microseconds(499);
    device->advance(now);
    EXPECT_TRUE(sent().empty());
    now = now + microseconds(1);
    device->advance(now);
    EXPECT_EQ(sent(), (Frames{"185#1100"}));
}

TEST_F(LongestTimesOfRpdos, LongestRpdoEventTimerIs65535Milliseconds) {
    verifies<req::CO_PDO_021>();
    send("605#2B001405FFFF0000");  // 1400h:5 event timer of RPDO1: 65,535 ms
    send("205#1122");
    EXPECT_TRUE(pass(longest_ms - 1).empty());
    EXPECT_EQ(pass(1), (Frames{"1:085#5082110100000000"}));
}

}  // namespace canproof::test
