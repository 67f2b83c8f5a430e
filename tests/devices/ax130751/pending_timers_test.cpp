// SPDX-License-Identifier: Apache-2.0
// Tests the timers of the relay of an AX130751 (its delays and its blinking) with each event that can end, keep, force
// or restart them (manual, 1.4). Cycles run every millisecond and use the values written before.
#include <functional>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751PendingTimers : public Ax130751Blocks {
  protected:
    static constexpr int never_changes = -1;

    /// An event that begins and ends while a delayed change of the relay is pending. Also the state of the relay during
    /// the event, and the time from the end of the event to the change, in ms.
    struct Case {
        std::string name;
        std::function<void()> begins;
        bool meanwhile;
        std::function<void()> ends;
        int changes_after;
    };

    void SetUp() override {
        Ax130751Blocks::SetUp();
        for (int number = 1; number <= 3; ++number) {
            extra_as_percent(number);
        }
    }
    void command_relay(int state) { set8(0x6220, 3, state); }
    void temperature(float celsius) {
        inputs.cpu_temperature = celsius;
        set_inputs();
    }
    /// Connects enable to 2500h:1 (EC Extra Received Process Value) and override to 2500h:2. Neither is active.
    void connect_relay() {
        set8(0x2280, 1, canopen);
        set8(0x2281, 1, 4);
        set8(0x2282, 1, 4);  // response 4: enabled while the input is ON; otherwise the relay keeps its state
        set16(0x2500, 1, 100);
        set8(0x2290, 1, canopen);
        set8(0x2291, 1, 5);
        set8(0x22A0, 1, 1);
        set32(0x22A1, 1, 30);
        set32(0x22A2, 1, 20);
        pass(1);
    }
    /// Checks one case. Before the case, the relay was in state `rest`. When the event begins, the opposite state has
    /// been commanded for 10 ms. The event lasts 6 ms.
    void expect(const Case& one, bool rest) {
        one.begins();
        pass(1);
        EXPECT_EQ(relay_on(), one.meanwhile) << one.name;
        pass(4);
        EXPECT_EQ(relay_on(), one.meanwhile) << one.name;
        one.ends();
        pass(1);
        const int wait = one.changes_after == never_changes ? 200 : one.changes_after;
        if (one.changes_after != 0) {
            pass(static_cast<std::uint64_t>(wait - 1));
            EXPECT_EQ(relay_on(), rest) << one.name;
            pass(1);
        }
        EXPECT_EQ(relay_on(), one.changes_after == never_changes ? rest : !rest) << one.name;
    }
};

}  // namespace

TEST_F(Ax130751PendingTimers, EachNmtCommandSdoWriteAndFaultKeepsEndsOrRestartsTheRelayOnDelay) {
    verifies<req::AOR_RELAY_012, req::AOR_RELAY_014, req::AOR_RELAY_023, req::AOR_RELAY_015, req::AOR_RELAY_009>();
    const auto nothing = [] {};
    const std::vector<Case> cases{
        // The delay is 30 ms; 10 ms have passed when the event begins, 16 when it ends.
        {"nothing happens", nothing, false, nothing, 30 - 16},
        {"the wish goes away", [&] { command_relay(0); }, false, [&] { command_relay(1); }, 30},
        {"override OFF", [&] { set16(0x2500, 2, 100); }, false, [&] { set16(0x2500, 2, 0); }, 30},
        {"override ON",
         [&] {
             set8(0x2293, 1, 1);
             set16(0x2500, 2, 100);
         },
         true, [&] { set16(0x2500, 2, 0); }, 0},
        {"disabled, kept", [&] { set16(0x2500, 1, 0); }, false, [&] { set16(0x2500, 1, 100); }, 30},
        {"disabled, OFF",
         [&] {
             set8(0x2282, 1, 0);
             set16(0x2500, 1, 0);
         },
         false, [&] { set16(0x2500, 1, 100); }, 30},
        {"shutdown", [&] { temperature(90.0F); }, false, [&] { temperature(20.0F); }, 30},
        {"no control", [&] { set8(0x2260, 1, not_used); }, false, [&] { set8(0x2260, 1, canopen); }, 30},
        {"pre-operational", [&] { send("000#807F"); }, false, [&] { start(); }, 30},
        {"reset communication", [&] { send("000#827F"); }, false, [&] { start(); }, 30},
        {"inverse polarity", [&] { set8(0x2242, 1, 2); }, false, [&] { set8(0x2242, 1, 1); }, 30},
        {"a longer delay", [&] { set32(0x22A1, 1, 90); }, false, nothing, 90 - 16},
        {"a delay that is over", [&] { set32(0x22A1, 1, 5); }, true, nothing, 0},
        {"the other delay", [&] { set32(0x22A2, 1, 5); }, false, nothing, 30 - 16},
        {"no delays", [&] { set8(0x22A0, 1, 0); }, true, nothing, 0},
        {"delays off and on", [&] { set8(0x22A0, 1, 0); }, true, [&] { set8(0x22A0, 1, 1); }, 0},
        {"reset node", [&] { send("000#817F"); }, false, [&] { start(); }, never_changes},
    };
    for (const Case& one : cases) {
        SetUp();
        connect_relay();
        command_relay(1);
        pass(1);  // the relay reads the command in this cycle
        pass(10);
        ASSERT_FALSE(relay_on()) << one.name;
        expect(one, false);
    }
}

TEST_F(Ax130751PendingTimers, EachNmtCommandSdoWriteAndFaultKeepsEndsOrRestartsTheRelayOffDelay) {
    verifies<req::AOR_RELAY_013, req::AOR_RELAY_022, req::AOR_RELAY_014, req::AOR_RELAY_023, req::AOR_RELAY_015>();
    const auto nothing = [] {};
    const std::vector<Case> cases{
        // The delay is 20 ms; 10 ms have passed when the event begins, 16 ms when it ends.
        {"nothing happens", nothing, true, nothing, 20 - 16},
        {"the wish goes away", [&] { command_relay(1); }, true, [&] { command_relay(0); }, 20},
        {"override OFF", [&] { set16(0x2500, 2, 100); }, false, [&] { set16(0x2500, 2, 0); }, 0},
        {"override ON",
         [&] {
             set8(0x2293, 1, 1);
             set16(0x2500, 2, 100);
         },
         true, [&] { set16(0x2500, 2, 0); }, 20},
        {"disabled, kept", [&] { set16(0x2500, 1, 0); }, true, [&] { set16(0x2500, 1, 100); }, 20},
        {"shutdown", [&] { temperature(90.0F); }, false, [&] { temperature(20.0F); }, 0},
        {"pre-operational", [&] { send("000#807F"); }, false, [&] { start(); }, 0},
        {"a longer delay", [&] { set32(0x22A2, 1, 90); }, true, nothing, 90 - 16},
        {"a delay that is over", [&] { set32(0x22A2, 1, 5); }, false, nothing, 0},
        {"the other delay", [&] { set32(0x22A1, 1, 5); }, true, nothing, 20 - 16},
        {"no delays", [&] { set8(0x22A0, 1, 0); }, false, nothing, 0},
        {"reset node", [&] { send("000#817F"); }, false, [&] { start(); }, 0},
    };
    for (const Case& one : cases) {
        SetUp();
        connect_relay();
        set32(0x22A1, 1, 0);
        command_relay(1);
        pass(1);
        command_relay(0);
        pass(1);  // this cycle reads the command
        pass(10);
        ASSERT_TRUE(relay_on()) << one.name;
        expect(one, true);
    }
}

TEST_F(Ax130751PendingTimers, EachNmtCommandSdoWriteAndFaultKeepsEndsOrRestartsTheRelayBlinking) {
    verifies<req::AOR_RELAY_008, req::AOR_RELAY_009, req::AOR_RELAY_010>();
    const auto nothing = [] {};
    const std::vector<Case> cases{
        // The relay blinks, 40 ms ON and 40 ms OFF. When blinking restarts, it begins with ON.
        {"nothing happens", nothing, true, nothing, 40 - 16},
        {"the control goes away", [&] { command_relay(0); }, false, [&] { command_relay(1); }, 40},
        {"override OFF", [&] { set16(0x2500, 2, 100); }, false, [&] { set16(0x2500, 2, 0); }, 40},
        {"override ON",
         [&] {
             set8(0x2293, 1, 1);
             set16(0x2500, 2, 100);
         },
         true, [&] { set16(0x2500, 2, 0); }, 40},
        {"disabled, kept", [&] { set16(0x2500, 1, 0); }, true, [&] { set16(0x2500, 1, 100); }, 40},
        {"shutdown", [&] { temperature(90.0F); }, false, [&] { temperature(20.0F); }, 40},
        {"pre-operational", [&] { send("000#807F"); }, false, [&] { start(); }, 40},
        {"reset communication", [&] { send("000#827F"); }, false, [&] { start(); }, 40},
        {"another polarity", [&] { set8(0x2242, 1, 1); }, true, [&] { set8(0x2242, 1, 5); }, 40},
        {"a slower rate", [&] { set16(0x2250, 1, 90); }, true, nothing, 90 - 16},
        {"no rate", [&] { set16(0x2250, 1, 0); }, true, nothing, never_changes},
    };
    for (const Case& one : cases) {
        SetUp();
        connect_relay();
        set8(0x22A0, 1, 0);
        set16(0x2250, 1, 40);
        set8(0x2242, 1, 5);
        command_relay(1);
        pass(1);  // this cycle reads the command
        pass(10);
        ASSERT_TRUE(relay_on()) << one.name;
        expect(one, true);
    }
}

TEST_F(Ax130751PendingTimers, PendingChangeOfTheRelayIsDroppedByResetNode) {
    verifies<req::AOR_OUT_026>();
    connect_relay();
    command_relay(1);
    pass(10);
    send("000#817F");
    pass(1);
    start();
    pass(200);
    EXPECT_FALSE(relay_on());
    command_relay(1);
    pass(1);
    EXPECT_TRUE(relay_on()) << "no delay as shipped, and none is left over";
}

}  // namespace canproof::test
