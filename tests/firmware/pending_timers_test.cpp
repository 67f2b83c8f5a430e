// SPDX-License-Identifier: Apache-2.0
// Tests the timers of the CANopen services that all devices share, each set to 100 ms. In each case, one event happens
// 40 ms after the start of the timer. Depending on the event, the timer continues, ends or restarts (CiA 301, 7.2.2,
// 7.2.5, 7.2.8).
#include <gtest/gtest.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Case {
    std::string name;
    std::vector<std::string> event;  ///< frames that the node receives at 40 ms
    Frames later;                    ///< frames that the node sends within 300 ms after the event
};

/// Performs each case on a newly booted slave: the frames in `arms` start the timer, and the event follows 40 ms later.
void expect(const std::vector<std::string>& arms, const std::vector<Case>& cases) {
    for (const Case& one : cases) {
        SlaveBench bench;
        for (const std::string& frame : arms) {
            bench.send(frame);
        }
        EXPECT_EQ(bench.pass(40), Frames{}) << one.name;
        for (const std::string& frame : one.event) {
            bench.send(frame);
        }
        EXPECT_EQ(bench.pass(300), one.later) << one.name;
    }
}

/// Returns `frame` once for each time at which it is expected: at `first` ms and every `period` ms after that, until
/// 300 ms.
Frames each(int first, int period, const std::string& frame) {
    Frames all;
    for (int at = first; at <= 300; at += period) {
        all.push_back(std::to_string(at) + ":" + frame);
    }
    return all;
}

}  // namespace

TEST(PendingTimer, HeartbeatPeriodContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_HB_001, req::CO_NMT_006, req::CO_HB_005>();
    expect({"605#2B17100064000000"}, {
                                         {"nothing", {}, each(60, 100, "705#7F")},
                                         {"start", {"000#0105"}, each(60, 100, "705#05")},
                                         {"stop", {"000#0205"}, each(60, 100, "705#04")},
                                         {"a guarding request", {"705#R1"}, each(60, 100, "705#7F")},
                                         {"a new period", {"605#2B17100032000000"}, each(50, 50, "705#7F")},
                                         {"none", {"605#2B17100000000000"}, {}},
                                         {"reset communication", {"000#8205"}, {}},
                                         {"reset node", {"000#8105"}, {}},
                                     });
}

TEST(PendingTimer, HeartbeatMonitoringContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_HB_004, req::CO_HB_003, req::CO_NMT_006>();
    const Frames lost{"60:085#3081110100000000"};
    expect({"605#2316100164003100", "731#05"},
           {
               {"nothing", {}, lost},
               {"another one", {"731#05"}, {"100:085#3081110100000000"}},
               {"one of another node", {"732#05"}, lost},
               {"another entry", {"605#23161002C8003200"}, lost},
               {"a longer time, from the next one on", {"605#23161001C8003100"}, {}},
               {"a longer time and one", {"605#23161001C8003100", "731#05"}, {"200:085#3081110100000000"}},
               {"none", {"605#2316100100000000"}, {}},
               {"stop: told when it is over", {"000#0205"}, {}},
               {"reset communication", {"000#8205"}, {}},
               {"reset node", {"000#8105"}, {}},
           });
}

TEST(PendingTimer, GuardingLifeTimeContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_GUARD_007, req::CO_GUARD_008, req::CO_NMT_006>();
    expect({"605#2B0C100032000000", "605#2F0D100002000000", "705#R1"},  // guard time 50 ms, life time factor 2
           {
               {"nothing", {}, {"60:085#3081110100000000"}},
               {"a request", {"705#R1"}, {"100:085#3081110100000000"}},
               {"a longer time", {"605#2B0C100064000000"}, {"200:085#3081110100000000"}},
               {"no factor", {"605#2F0D100000000000"}, {}},
               {"a heartbeat instead", {"605#2B171000E8030000"}, {}},
               {"reset communication", {"000#8205"}, {}},
               {"reset node", {"000#8105"}, {}},
           });
}

TEST(PendingTimer, SyncPeriodContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_SYNC_003, req::CO_NMT_006>();
    expect({"605#23061000A0860100", "605#2305100080000040"},  // SYNC period 100,000 us
           {
               {"nothing", {}, each(60, 100, "080#")},
               {"a new period", {"605#2306100050C30000"}, each(50, 50, "080#")},
               {"stop", {"000#0205"}, {}},
               {"stop and pre-operational", {"000#0205", "000#8005"}, each(100, 100, "080#")},
               {"no producer", {"605#2305100080000000"}, {}},
               {"reset communication", {"000#8205"}, {}},
               {"reset node", {"000#8105"}, {}},
           });
}

TEST(PendingTimer, RpdoMonitoringContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_PDO_021, req::CO_PDO_039, req::CO_PDO_040, req::CO_NMT_006, req::CO_PDO_066>();
    const Frames late{"60:085#5082110100000000"};
    expect({"605#2B00140564000000", "000#0105", "205#1122"},
           {
               {"nothing", {}, late},
               {"another one", {"205#3344"}, {"100:085#5082110100000000"}},
               {"one that is too short", {"205#11"}, {"60:085#5082110200000000"}},
               {"another RPDO", {"305#0100020003000400"}, late},
               {"a longer time, from the next one on", {"605#2B001405C8000000"}, {}},
               {"switched off", {"605#2300140105020080"}, {}},
               {"pre-operational", {"000#8005"}, {}},
               {"pre-operational and start", {"000#8005", "000#0105"}, {}},
               {"reset communication", {"000#8205"}, {}},
               {"reset communication and start", {"000#8205", "000#0105"}, {}},
               {"reset node and start", {"000#8105", "000#0105"}, {}},
           });
}

TEST(PendingTimer, TpdoEventTimerContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_PDO_047, req::CO_PDO_025, req::CO_PDO_051, req::CO_PDO_027, req::CO_PDO_052>();
    expect({"605#2B00180564000000", "000#0105"},
           {
               {"nothing", {}, each(60, 100, "185#0000")},
               {"an event", {"605#2F01200111000000"}, each(100, 100, "185#1100")},
               {"the same time", {"605#2B00180564000000"}, each(60, 100, "185#0000")},
               {"another time", {"605#2B00180532000000"}, each(50, 50, "185#0000")},
               {"none", {"605#2B00180500000000"}, {}},
               {"switched off", {"605#2300180185010080"}, {}},
               {"start", {"000#0105"}, each(60, 100, "185#0000")},
               {"pre-operational", {"000#8005"}, {}},
               {"pre-operational and start", {"000#8005", "000#0105"}, each(100, 100, "185#0000")},
               {"reset communication and start", {"000#8205", "000#0105"}, {}},
           });
}

TEST(PendingTimer, TpdoInhibitTimeContinuesEndsOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_PDO_017, req::CO_PDO_048, req::CO_PDO_018, req::CO_PDO_027, req::CO_PDO_052>();
    const std::string change = "605#2F01200122000000";
    expect({"605#2300180185010080", "605#2B001803E8030000", "605#2300180185010000",  // 1000 * 100 us
            "000#0105", "605#2F01200111000000"},
           {
               {"nothing", {}, {"60:185#1100"}},
               {"another change", {change}, {"60:185#2200"}},
               {"start", {"000#0105"}, {"60:185#1100"}},
               {"pre-operational", {"000#8005"}, {}},
               {"pre-operational and start: sent at once, and inhibited from then on",
                {"000#8005", "000#0105", change},
                {"100:185#2200"}},
               {"switched off", {"605#2300180185010080"}, {}},
               {"reset communication and start", {"000#8205", "000#0105", change}, {}},
           });
}

TEST(PendingTimer, TpdoSyncCountContinuesOrRestartsAtAnNmtCommandOrWrite) {
    verifies<req::CO_PDO_014>();
    const std::vector<Case> cases{
        {"nothing", {}, {"1"}},
        {"start", {"000#0105"}, {"1"}},
        {"pre-operational and start", {"000#8005", "000#0105"}, {"3"}},
        {"another type and back", {"605#2F00180202000000", "605#2F00180203000000"}, {"3"}},
        {"reset communication, type and start", {"000#8205", "605#2F00180203000000", "000#0105"}, {"3"}},
    };
    for (const Case& one : cases) {
        SlaveBench bench;
        for (const char* frame :
             // 1800h:2 is 3, so TPDO1 is sent at every third SYNC; two have passed
             {"605#2F00180203000000", "000#0105", "080#", "080#"}) {
            bench.send(frame);
        }
        for (const std::string& frame : one.event) {
            bench.send(frame);
        }
        int syncs = 1;
        for (Frames said = bench.send("080#"); syncs < 9; said = bench.send("080#")) {
            if (std::find(said.begin(), said.end(), "185#0000") != said.end()) {
                break;
            }
            ++syncs;
        }
        EXPECT_EQ(Frames{std::to_string(syncs)}, one.later) << one.name;
    }
}

}  // namespace canproof::test
