// SPDX-License-Identifier: Apache-2.0
// Tests which internal states an AX130751 clears at a reset, when an output gets a new type, and when a source is
// removed. These are the states of hystereses, faults and blocks (manual, 1.2 to 1.8).
#include <array>
#include <functional>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Restart : public Ax130751Blocks {
  protected:
    /// Connects an input to the supply voltage: the input is OFF at 12 V and below, ON at 30 V and above.
    void follow_supply(std::uint16_t source_index, int sub) {
        set8(0x5021, 0, 0);
        set8(0x5023, 0, 30);
        set8(0x5022, 0, 12);
        set8(source_index, sub, supply_source);
    }
    void supply(float volts_supplied) {
        inputs.supply = volts_supplied;
        set_inputs();
        pass(1);
    }
    /// Switches the same object on again, as a host program can. Checks by output 1, of type PWM, that the first cycle
    /// comes after 1 ms.
    void expect_first_cycle_after_power_on() {
        switch_on([this] { device->power_on(inputs, now); });
        pass(0);
        EXPECT_EQ(device->outputs().out_frequency[0], 0.0F) << "no cycle has run since the power-on";
        pass(1);
        EXPECT_EQ(device->outputs().out_frequency[0], 25000.0F);
    }
    /// Checks that after reset node the input is OFF until the supply reaches 30 V again, and that reset communication
    /// keeps the state of the input.
    void forgets(const std::string& name, const std::function<bool()>& is_input_on) {
        SCOPED_TRACE(name);
        store();
        for (const char* reset : {"000#817F", "000#827F"}) {
            SCOPED_TRACE(reset);
            supply(30.0F);
            EXPECT_TRUE(is_input_on());
            supply(20.0F);
            EXPECT_TRUE(is_input_on()) << "as before";
            send(reset);
            start();
            pass(2);
            EXPECT_EQ(is_input_on(), std::string{reset} == "000#827F") << "OFF before it was ever outside";
            supply(30.0F);
            supply(12.0F);
            supply(20.0F);
            EXPECT_FALSE(is_input_on());
        }
        restore();
        send("000#817F");
        inputs.supply = 24.0F;
        set_inputs();
        start();
        pass(1);
    }
};

/// A digital output.
class Ax130751RestartOfOutput : public Ax130751Restart, public testing::WithParamInterface<int> {
  protected:
    void SetUp() override {
        Ax130751Restart::SetUp();
        set16(0x6310, output, 1020);
    }

    const int output{GetParam()};
};

}  // namespace

TEST_P(Ax130751RestartOfOutput, ResetNodeClearsTheHysteresisOfTheControlInput) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    follow_supply(0x2340, output);
    forgets("control", [&] { return is_on(output); });
}

TEST_P(Ax130751RestartOfOutput, ResetNodeClearsTheHysteresisOfTheEnableInput) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    set8(0x2241, output, 1);  // inverse: ON without a command
    set8(0x2352, output, 0);  // enable response 0: the output is enabled while its enable input is ON
    follow_supply(0x2350, output);
    forgets("enable", [&] { return is_on(output); });
}

TEST_P(Ax130751RestartOfOutput, ResetNodeClearsTheHysteresisOfTheOverrideInput) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    set16(0x2300, output, 1);
    set8(0x2362, output, 0);  // override response 0: the override works while its input is ON
    follow_supply(0x2360, output);
    forgets("override", [&] { return is_on(output); });
}

INSTANTIATE_TEST_SUITE_P(Each, Ax130751RestartOfOutput, testing::Values(1, 2));

TEST_F(Ax130751Restart, ResetNodeClearsTheHysteresisOfTheControlInputOfTheRelay) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    follow_supply(0x2260, 1);
    forgets("control", [&] { return relay_on(); });
}

TEST_F(Ax130751Restart, ResetNodeClearsTheHysteresisOfTheEnableInputOfTheRelay) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    set8(0x2242, 1, 2);  // inverse: ON without a command
    set8(0x2282, 1, 0);  // enable response 0: the relay is enabled while its enable input is ON
    follow_supply(0x2280, 1);
    forgets("enable", [&] { return relay_on(); });
}

TEST_F(Ax130751Restart, ResetNodeClearsTheHysteresisOfTheOverrideInputOfTheRelay) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    set8(0x2293, 1, 1);
    set8(0x2292, 1, 0);  // override response 0: the override works while its input is ON
    follow_supply(0x2290, 1);
    forgets("override", [&] { return relay_on(); });
}

TEST_F(Ax130751Restart, ResetNodeClearsTheHysteresisOfTheUnlatchInputOfTheRelay) {
    verifies<req::AOR_DO_002, req::AOR_OUT_026>();
    set8(0x2242, 1, 4);  // polarity 4 is the inverse latch: the relay goes OFF when its control goes OFF, unless it is
                         // unlatched
    follow_supply(0x2270, 1);
    forgets("unlatch", [&] {
        set8(0x6220, 3, 1);
        pass(1);
        set8(0x6220, 3, 0);
        pass(1);
        const bool unlatched = relay_on();
        set8(0x6220, 3, 1);
        pass(1);
        set8(0x6220, 3, 0);  // the relay is in its rest state again: ON
        pass(1);
        return unlatched;
    });
}

TEST_F(Ax130751Restart, LatchedAndDelayedRelayIsOffAfterAReset) {
    verifies<req::AOR_RELAY_003, req::AOR_RELAY_012, req::AOR_OUT_026>();
    set8(0x2242, 1, 3);  // polarity 3: latched
    store();
    set8(0x6220, 3, 1);
    pass(1);
    set8(0x6220, 3, 0);
    pass(1);
    EXPECT_TRUE(relay_on());
    send("000#817F");
    start();
    pass(5);
    EXPECT_FALSE(relay_on());
    set32(0x22A2, 1, 1000);
    set8(0x22A0, 1, 1);
    store();
    for (const int state : {1, 0, 1}) {  // commands ON, OFF, and ON again; the last change is delayed
        set8(0x6220, 3, state);
        pass(1);
    }
    EXPECT_TRUE(relay_on());
    send("000#817F");
    start();
    pass(5);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Restart, NewOutputTypeClearsTheHysteresisOfTheInputsOfTheOutput) {
    verifies<req::AOR_OUT_023, req::AOR_DO_002>();
    const auto type_changes = [this](const char* name) {
        SCOPED_TRACE(name);
        supply(30.0F);
        supply(20.0F);
        EXPECT_TRUE(is_on(2));
        set16(0x6310, 2, 1000);
        set16(0x2300, 2, 1);
        pass(2);
        EXPECT_FALSE(is_on(2));
        supply(30.0F);
        EXPECT_TRUE(is_on(2));
    };
    set16(0x6310, 2, 1020);
    follow_supply(0x2340, 2);
    type_changes("control");
    set8(0x2340, 2, canopen);
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 1);
    set8(0x2352, 2, 0);
    follow_supply(0x2350, 2);
    type_changes("enable");
    set8(0x2350, 2, not_used);
    set8(0x2241, 2, 0);
    set16(0x6310, 2, 1020);
    set16(0x2300, 2, 1);
    set8(0x2362, 2, 0);
    follow_supply(0x2360, 2);
    type_changes("override");
}

TEST_F(Ax130751Restart, ResetNodeEndsAFaultThatOnlyItsHysteresisKeepsActive) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_003, req::AOR_DIAG_004, req::AOR_OUT_026>();
    struct Case {
        const char* name;
        float beyond, within;  ///< V or degrees
        bool hot;
    };
    for (const Case& one : {Case{"under-voltage", 7.5F, 10.0F, false}, Case{"over-voltage", 36.0F, 32.0F, false},
                            Case{"temperature", 90.0F, 70.0F, true}}) {
        for (const bool whole : {true, false}) {
            SCOPED_TRACE(fmt::format("{}, {}", one.name, whole ? "node" : "communication"));
            float& measured = one.hot ? inputs.cpu_temperature : inputs.supply;
            const float sound = measured;
            measured = one.beyond;
            set_inputs();
            pass(1);
            measured = one.within;
            set_inputs();
            pass(1);
            EXPECT_EQ(read(0x1001, 0), 1U) << "until it has recovered";
            send(whole ? "000#817F" : "000#827F");
            pass(2);
            EXPECT_EQ(read(0x1001, 0), whole ? 0U : 1U);
            EXPECT_EQ(read(0x1003, 0), whole ? 0U : 1U) << "blocks go on with the communication's reset";
            measured = sound;
            set_inputs();
            start();
            pass(1);
        }
    }
}

// Table 1 and logic block 1 are evaluated before the blocks that they read here, so they have no input in the first
// cycle.
TEST_F(Ax130751Restart, BlockIsNotAvailableAfterAResetUntilItIsEvaluated) {
    verifies<req::AOR_OUT_001, req::AOR_OUT_026, req::AOR_LT_015, req::AOR_LOGIC_008>();
    extra_as_percent(1);
    set16(0x3017, 1, 50);  // 50 at X = 0
    set8(0x3020, 0, canopen);
    set8(0x3021, 0, 4);
    set8(0x3300, 1, 1);
    set8(0x3401, 1, 2);
    set8(0x3402, 1, 0);
    for (const int source : {lookup_source, logic_source}) {
        set8(0x3010, 0, source);
        set8(0x3011, 0, source == lookup_source ? 2 : 1);
        pass(5);
        EXPECT_EQ(get16(0x3018, 0), 50);
        store();
        for (const bool switched : {false, true}) {
            SCOPED_TRACE(fmt::format("source {}, {}", source, switched ? "power-on" : "reset"));
            if (switched) {
                power_on();
            } else {
                send("000#817F");
            }
            now = now + milliseconds(1);
            device->advance(now);
            EXPECT_EQ(device->objects().read(0x3018, 0), 0U) << "its source has not been evaluated yet";
            now = now + milliseconds(1);
            device->advance(now);
            EXPECT_EQ(device->objects().read(0x3018, 0), 50U);
        }
    }
}

TEST_F(Ax130751Restart, TimeProfileRestartsAfterItsSourceWasRemoved) {
    verifies<req::AOR_LT_010, req::AOR_LT_015>();
    extra_as_percent(1);
    set8(0x3015, 1, 1);
    set32(0x3016, 2, 100);
    set16(0x3017, 2, 100);
    set8(0x3015, 3, 0);
    set8(0x3011, 0, 4);
    set8(0x3010, 0, canopen);
    extra(1, 100);
    pass(60);
    EXPECT_EQ(get16(0x3018, 0), 60);
    set8(0x3010, 0, not_used);
    pass(1);
    set8(0x3010, 0, canopen);
    pass(1 + 20);
    EXPECT_EQ(get16(0x3018, 0), 20);
    extra(1, 50);
    EXPECT_EQ(get16(0x3018, 0), 21) << "still ON";
    set8(0x3010, 0, not_used);
    pass(1);
    set8(0x3010, 0, canopen);
    pass(10);
    EXPECT_EQ(get16(0x3018, 0), 0) << "OFF before it was ever outside";
}

TEST_F(Ax130751Restart, ResetRestartsTimeProfilesAndRestoresStoredPoints) {
    verifies<req::AOR_LT_010, req::AOR_LT_008, req::AOR_OUT_026>();
    const std::array<std::uint16_t, 3> tables{0x3010, 0x3070, 0x3100};
    const auto at = [](std::uint16_t table, int offset) { return static_cast<std::uint16_t>(table + offset); };
    for (const std::uint16_t table : tables) {
        follow_supply(table, 0);
        set8(at(table, 5), 1, 1);
        set32(at(table, 6), 2, 100);
        set16(at(table, 7), 2, 100);
        set8(at(table, 5), 3, 0);
    }
    store();
    supply(30.0F);
    pass(40);
    for (const std::uint16_t table : tables) {
        EXPECT_EQ(get16(at(table, 8), 0), 40) << table;
        set16(at(table, 7), 2, 200);
    }
    pass(1);
    for (const std::uint16_t table : tables) {
        EXPECT_EQ(get16(at(table, 8), 0), 82) << table;
    }
    send("000#817F");
    pass(1 + 20);
    for (const std::uint16_t table : tables) {
        EXPECT_EQ(get16(at(table, 8), 0), 20) << "of 100, which is stored, in table " << table;
    }
}

TEST_F(Ax130751Restart, SumOfAMathBlockIs0AfterAReset) {
    verifies<req::AOR_MATH_015, req::AOR_OUT_026>();
    // Function 1 adds 2500h:1 (EC Extra Received Process Value), in percent, to its own result.
    extra_as_percent(1);
    set8(0x4101, 1, 1);
    set8(0x4100, 1, math_source);
    set8(0x4102, 1, 1);
    set8(0x4101, 2, 4);
    set8(0x4100, 2, canopen);
    set8(0x4103, 2, 0);
    set16(0x4122, 2, 100);
    set8(0x4000, 1, 1);
    store();
    set16(0x2500, 1, 1);
    pass(30);
    set16(0x2500, 1, 0);
    pass(5);
    EXPECT_EQ(get16(0x4030, 1), 3000);
    send("000#817F");
    pass(5);
    EXPECT_EQ(get16(0x4030, 1), 0);
}

TEST_F(Ax130751Restart, UnsavedNodeIdAndBitRateSurviveResetCommunicationButNotResetNode) {
    verifies<req::AOR_NODE_003, req::AOR_NODE_006, req::AOR_NODE_007, req::AOR_OD_5B50, req::AOR_OD_5B51>();
    EXPECT_EQ(write(0x5B51, 0, 0x30, 1), "");
    EXPECT_EQ(write(0x5B50, 0, 3, 1), "");
    store();
    EXPECT_EQ(write(0x5B51, 0, 0x31, 1), "");
    EXPECT_EQ(write(0x5B50, 0, 2, 1), "");
    send("000#827F");
    EXPECT_EQ(read(0x5B51, 0), 0x31U) << "as written";
    EXPECT_EQ(read(0x5B50, 0), 2U);
    send("000#817F");
    EXPECT_EQ(device->node_id(), 127);
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(read(0x5B51, 0), 0x30U) << "as stored";
    EXPECT_EQ(read(0x5B50, 0), 3U);
}

TEST_F(Ax130751Restart, FirstCycleComesAMillisecondAfterPowerOnAlsoWhenAProducerWasLost) {
    verifies<req::AOR_OUT_001>();
    set16(0x6310, 1, 40);          // 6310h:1 (AO Output Type): PWM
    set32(0x1016, 1, 0x00200014);  // 1016h:1 (consumer heartbeat time): node 32, 20 ms
    store();
    send("720#05");
    pass(20);
    EXPECT_EQ(read(0x1003, 1), 0x80208130U) << "node 32 is lost";
    EXPECT_EQ(device->outputs().out_frequency[0], 25000.0F);
    expect_first_cycle_after_power_on();
}

TEST_F(Ax130751Restart, FirstCycleComesAMillisecondAfterPowerOnAlsoWhenAnRpdoWasOverdue) {
    verifies<req::AOR_OUT_001>();
    set16(0x6310, 1, 40);  // 6310h:1 (AO Output Type): PWM
    set16(0x1400, 5, 20);  // 1400h:5 (event timer of RPDO1): 20 ms
    store();
    start();
    send("27F#0000000000");
    pass(20);
    EXPECT_EQ(read(0x1003, 1), 0x00008100U) << "RPDO1 is overdue";
    expect_first_cycle_after_power_on();
}

}  // namespace canproof::test
