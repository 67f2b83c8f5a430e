// SPDX-License-Identifier: Apache-2.0
// Tests two timers of the CAN-CBX-AO412 with each event that can end, keep or restart them. The timers are the delay of
// the self-start (1F80h NMT Startup, 1F91h self-start delay) and the inhibit time of emergency messages (manual,
// 7.9.15, 7.9.22, 7.9.23).
#include <functional>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr int never_started = -1;

class CbxPendingTimers : public testing::Test, public CbxBench {
  protected:
    /// An event that happens 200 ms after the boot-up, and the time at which the node starts itself, in ms after the
    /// boot-up.
    struct Case {
        std::string name;
        std::function<void()> happens;
        int starts_at;
    };

    /// Powers on a node that starts itself 500 ms after the boot-up.
    void begin() {
        inputs = cbx_ao412::Inputs{};
        power_on();
        write("603#23801F0008000000");
        write("603#2B911F01F4010000");
        write("603#2310100173617665");
        power_on();
    }
    /// Waits until the node is operational. Returns the time since the boot-up in ms (`gone` ms have passed already),
    /// or never_started after two seconds.
    int started_after(int gone) {
        for (int i = gone; i < 2000; ++i) {
            if (device->state() == NmtState::operational) {
                return i;
            }
            pass(1);
        }
        return never_started;
    }
};

}  // namespace

TEST_F(CbxPendingTimers, EachNmtCommandSdoWriteAndFailureKeepsEndsOrRestartsTheSelfStartDelay) {
    verifies<req::AO4_START_001, req::AO4_START_003, req::AO4_START_006, req::AO4_START_004>();
    const std::vector<Case> cases{
        {"nothing happens", [] {}, 500},
        {"start", [&] { send("000#0103"); }, 200},
        {"start all", [&] { send("000#0100"); }, 200},
        {"stop", [&] { send("000#0203"); }, never_started},
        {"enter pre-operational", [&] { send("000#8003"); }, never_started},
        {"a command to another node", [&] { send("000#0204"); }, 500},
        {"reset node", [&] { send("000#8103"); }, 200 + 500},
        {"reset communication", [&] { send("000#8203"); }, 200 + 500},
        {"a new delay", [&] { write("603#2B911F012C010000"); }, 500},
        {"a new delay and reset communication",
         [&] {
             write("603#2B911F012C010000");  // 1F91h:1 self-start delay: 300 ms, not stored
             send("000#8203");
         },
         200 + 500},
        {"switched off", [&] { write("603#23801F0002000000"); }, 500},
        {"an internal failure",
         [&] {
             inputs.internal_fault = true;
             set_inputs();
         },
         500},
        {"bus-off that ends",
         [&] {
             inputs.can_state = 3;
             set_inputs();
             inputs.can_state = 0;
             set_inputs();
         },
         never_started},
    };
    for (const Case& one : cases) {
        begin();
        EXPECT_EQ(pass(200), Frames{}) << one.name;
        one.happens();
        EXPECT_EQ(started_after(200), one.starts_at) << one.name;
    }
}

TEST_F(CbxPendingTimers, EachNmtCommandAndSdoWriteKeepsEndsOrRestartsTheEmcyInhibitTime) {
    verifies<req::CO_EMCY_003, req::CO_EMCY_020, req::CO_EMCY_004, req::CO_EMCY_018, req::AO4_OD_1015>();
    struct Told {
        std::string name;
        std::function<Frames()> happens;  ///< the event, 40 ms after the first of two emergency messages; without it,
                                          ///< the second one is sent 100 ms after the first
        Frames at_once;
        Frames later;  ///< frames with their times in ms after the event
    };
    const std::string waits = "083#2081110200000000";
    const Frames done{"60:" + waits};
    const std::vector<Told> cases{
        {"nothing happens", [] { return Frames{}; }, {}, done},
        {"start", [&] { return send("000#0103"); }, {}, done},
        {"stopped, and pre-operational after 100 ms",
         [&] {
             send("000#0203");
             EXPECT_EQ(pass(100), Frames{});
             return send("000#8003");
         },
         {waits},
         {}},
        {"a longer time", [&] { return send("603#2B151000D0070000"); }, {"583#6015100000000000"}, done},
        {"no time", [&] { return send("603#2B15100000000000"); }, {"583#6015100000000000"}, done},
        {"no messages", [&] { return send("603#2314100083000080"); }, {"583#6014100000000000"}, {}},
        {"reset communication", [&] { return send("000#8203"); }, {"703#00", "083#2081110000000000"}, {}},
        {"reset node: both lost frames and error passive are reported again",
         [&] { return send("000#8103"); },
         {"703#00", "083#1081110200000000", "083#2081110200000000"},
         {}},
    };
    for (const Told& one : cases) {
        inputs = cbx_ao412::Inputs{};
        power_on();
        write("603#2B151000E8030000");  // 1015h inhibit time EMCY: 1000 * 100 us = 100 ms
        inputs.can_overrun = true;
        EXPECT_EQ(set_inputs().size(), 1U);
        inputs.can_state = 2;
        EXPECT_EQ(set_inputs(), Frames{});
        EXPECT_EQ(pass(40), Frames{});
        EXPECT_EQ(one.happens(), one.at_once) << one.name;
        EXPECT_EQ(pass(500), one.later) << one.name;
    }
}

}  // namespace canproof::test
