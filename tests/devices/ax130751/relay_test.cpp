// SPDX-License-Identifier: Apache-2.0
// Tests the relay of the AX130751, which the tests set up by SDO (manual, 1.4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/relay_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax130751Relay, RelayOnClosesContactNcAndRelayOffClosesContactNo) {
    verifies<req::AOR_RELAY_001, req::AOR_T_CONTACT, req::AOR_S_RELAY_NC, req::AOR_S_RELAY_NO>();
    EXPECT_FALSE(device->outputs().relay_nc) << "OFF as shipped";
    EXPECT_TRUE(device->outputs().relay_no);
    control(1);
    EXPECT_TRUE(device->outputs().relay_nc);
    EXPECT_FALSE(device->outputs().relay_no);
}

TEST_F(Ax130751Relay, RelayPolaritiesFollowTable10) {
    verifies<req::AOR_RELAY_002, req::AOR_RELAY_003, req::AOR_RELAY_004, req::AOR_T10, req::AOR_SRC_003>();
    const auto answers = [this](int polarity) {
        control(0);
        set8(0x2242, 1, polarity);
        pass(1);
        std::string seen{relay_on() ? '#' : '.'};
        for (const int state : {1, 0, 1, 0}) {
            seen += control(state) ? '#' : '.';
        }
        return seen;
    };
    EXPECT_EQ(answers(0), ".....");
    EXPECT_EQ(answers(1), ".#.#.");
    EXPECT_EQ(answers(2), "#.#.#");
    EXPECT_EQ(answers(3), ".##..");
    EXPECT_EQ(answers(4), "##..#");
    EXPECT_EQ(answers(5), ".#.#.");
    EXPECT_EQ(get8(0x6220, 3), 0) << "the device does not write the command";
}

TEST_F(Ax130751Relay, RelayTogglesAtItsBlinkRate) {
    verifies<req::AOR_RELAY_008, req::AOR_RELAY_026>();
    set8(0x2242, 1, 5);
    EXPECT_TRUE(control(1));
    pass(499);
    EXPECT_TRUE(relay_on());
    pass(1);
    EXPECT_FALSE(relay_on()) << "500 ms as shipped: the time in one state";
    pass(500);
    EXPECT_TRUE(relay_on());
    set16(0x2250, 1, 0);
    pass(700);
    EXPECT_TRUE(relay_on());
    EXPECT_FALSE(control(0));
}

TEST_F(Ax130751Relay, EnableResponsesFollowTable11) {
    verifies<req::AOR_RELAY_009, req::AOR_T11, req::AOR_E_OUTPUT_DRIVE, req::AOR_RELAY_027>();
    connect(0x2280, 1);
    // Returns two states of the relay, both with control ON: the first with the enable input at `on_first`, the second
    // with the enable input at the opposite state.
    const auto answers = [this](int response, bool on_first) {
        set8(0x2280, 1, not_used);
        set8(0x2282, 1, response);
        EXPECT_TRUE(control(1)) << "an enable that is not used is ignored";
        set16(0x2500, 1, on_first ? 100 : 0);
        set8(0x2280, 1, canopen);
        pass(1);
        const bool first = relay_on();
        extra(1, on_first ? 0 : 100);
        return std::pair{first, relay_on()};
    };
    using Pair = std::pair<bool, bool>;
    EXPECT_EQ(answers(0, true), (Pair{true, false}));
    EXPECT_EQ(answers(1, true), (Pair{false, true}));
    EXPECT_EQ(answers(2, true), (Pair{false, true}));
    EXPECT_EQ(answers(3, true), (Pair{true, false}));
    // response 4: the relay is enabled while the input is ON, and keeps its state while the input is OFF
    EXPECT_EQ(answers(4, true), (Pair{true, true}));
    control(0);
    EXPECT_TRUE(relay_on()) << "kept";
    extra(1, 100);
    EXPECT_FALSE(relay_on());
    // response 5: the relay is enabled while the input is OFF, and keeps its state while the input is ON
    EXPECT_EQ(answers(5, false), (Pair{true, true}));
    control(0);
    EXPECT_TRUE(relay_on()) << "kept";
    extra(1, 0);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Relay, DisabledRelayIsOffEvenWithInverseLogic) {
    verifies<req::AOR_RELAY_009>();
    set8(0x2242, 1, 2);
    connect(0x2280, 1);
    extra(1, 100);
    EXPECT_TRUE(relay_on());
    extra(1, 0);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Relay, OverrideResponsesFollowTable12ForBothOverrideStates) {
    verifies<req::AOR_RELAY_010, req::AOR_T12, req::AOR_T11B>();
    connect(0x2290, 2);
    const auto answer = [this](int response, int state, int signal, int command) {
        set8(0x2292, 1, response);
        set8(0x2293, 1, state);
        set16(0x2500, 2, signal);
        return control(command);
    };
    for (const int command : {0, 1}) {
        for (const int state : {0, 1}) {
            EXPECT_EQ(answer(0, state, 100, command), state == 1);
            EXPECT_EQ(answer(0, state, 0, command), command == 1);
            EXPECT_EQ(answer(1, state, 0, command), state == 1);
            EXPECT_EQ(answer(1, state, 100, command), command == 1);
        }
    }
}

TEST_F(Ax130751Relay, OverridePrecedesEnable) {
    verifies<req::AOR_RELAY_010>();
    connect(0x2280, 1);  // enable response 0, input OFF: the relay would be disabled
    connect(0x2290, 2);
    set8(0x2293, 1, 1);
    extra(2, 100);
    EXPECT_TRUE(relay_on());
}

TEST_F(Ax130751Relay, RelayGoesOffWhileItsControlInputIsInError) {
    verifies<req::AOR_RELAY_011, req::AOR_SRC_004>();
    set16(0x1400, 5, 50);  // event timer of RPDO1, which maps 6220h:3: 50 ms
    start();
    send("27F#0000000001");
    pass(5);
    EXPECT_TRUE(relay_on());
    pass(60);
    EXPECT_FALSE(relay_on());
    send("27F#0000000001");
    pass(5);
    EXPECT_TRUE(relay_on());
}

TEST_F(Ax130751Relay, RelayGoesOffWhenItsEnableOverrideOrUsedUnlatchInputIsInError) {
    verifies<req::AOR_RELAY_011, req::AOR_SRC_004>();
    struct Case {
        std::uint16_t source;
        int polarity;
        bool errs;
    };
    set32(0x1401, 1, 0x4000037F);  // RPDO2, which maps 2500h:1 (EC Extra Received Process Value), becomes valid
    set16(0x1401, 5, 100);
    start();
    for (const Case& one : std::vector<Case>{{0x2280, 1, true},     // the enable input
                                             {0x2290, 1, true},     // the override input
                                             {0x2270, 1, false},    // unlatch of a relay without a latch
                                             {0x2270, 3, true}}) {  // unlatch of a latched relay
        set8(0x2242, 1, one.polarity);
        set8(0x2292, 1, 0);  // override response 0: the override works while its input is ON; the input is OFF here
        connect(one.source, 1);
        send("37F#640000000000");
        send("37F#000000000000");
        if (one.source == 0x2280) {
            send("37F#640000000000");
        }
        control(0);
        control(1);
        EXPECT_TRUE(relay_on()) << one.source << ' ' << one.polarity;
        pass(150);
        EXPECT_EQ(relay_on(), !one.errs) << one.source << ' ' << one.polarity;
        set8(one.source, 1, not_used);
    }
}

TEST_F(Ax130751Relay, DelaysApplyToSwitchingOnAndOff) {
    verifies<req::AOR_RELAY_012, req::AOR_RELAY_013, req::AOR_RELAY_022>();
    set32(0x22A1, 1, 30);
    set32(0x22A2, 1, 20);
    EXPECT_TRUE(control(1)) << "delays are off as shipped";
    control(0);
    set8(0x22A0, 1, 1);
    EXPECT_FALSE(control(1));  // the cycle of this call starts the ON delay of 30 ms
    pass(29);
    EXPECT_FALSE(relay_on());
    pass(1);
    EXPECT_TRUE(relay_on());
    EXPECT_TRUE(control(0));
    pass(10);
    control(1);  // the command ON again cancels the pending change to OFF
    pass(50);
    EXPECT_TRUE(relay_on());
    control(0);
    pass(19);
    EXPECT_TRUE(relay_on()) << "the whole delay again";
    pass(1);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Relay, DelayOfADayIsExact) {
    verifies<req::AOR_RELAY_012>();
    set32(0x22A1, 1, 86'400'000);
    set8(0x22A0, 1, 1);
    control(1);
    now = now + milliseconds(86'399'999);
    device->advance(now);
    EXPECT_FALSE(relay_on());
    pass(1);
    EXPECT_TRUE(relay_on());
}

TEST_F(Ax130751Relay, OverrideAndShutdownAreNotDelayed) {
    verifies<req::AOR_RELAY_014, req::AOR_RELAY_023>();
    connect(0x2290, 2);
    set8(0x2293, 1, 1);
    set32(0x22A1, 1, 30);
    set32(0x22A2, 1, 20);
    set8(0x22A0, 1, 1);
    extra(2, 100);
    EXPECT_TRUE(relay_on());
    extra(2, 0);
    EXPECT_TRUE(relay_on());
    pass(20);
    EXPECT_FALSE(relay_on()) << "the way back is delayed";
    extra(2, 100);
    inputs.cpu_temperature = 90.0F;
    set_inputs();
    pass(1);
    EXPECT_FALSE(relay_on()) << "shutdown";
}

TEST_F(Ax130751Relay, DelaysShiftTheWholeTogglePatternOfTheRelay) {
    verifies<req::AOR_RELAY_015>();
    set8(0x2242, 1, 5);
    set16(0x2250, 1, 10);
    set32(0x22A1, 1, 30);
    set32(0x22A2, 1, 25);
    set8(0x22A0, 1, 1);
    control(1);
    pass(29);
    EXPECT_FALSE(relay_on());
    pass(1);
    EXPECT_TRUE(relay_on());
    pass(10);
    EXPECT_FALSE(relay_on());
    control(0);
    pass(9);
    EXPECT_TRUE(relay_on()) << "goes on toggling";
    pass(16);
    EXPECT_FALSE(relay_on());
    pass(20);
    EXPECT_FALSE(relay_on());
}

TEST_F(Ax130751Relay, RelayWithoutAControlIsOffAlsoWithInversePolarities) {
    verifies<req::AOR_RELAY_016, req::AOR_RELAY_024>();
    EXPECT_TRUE(control(1));
    set8(0x2260, 1, not_used);
    pass(1);
    EXPECT_FALSE(relay_on());
    for (const int polarity : {2, 4}) {
        set8(0x2242, 1, polarity);
        pass(1);
        EXPECT_FALSE(relay_on()) << "polarity " << polarity << ": OFF, not the inverse of OFF";
    }
    set8(0x2260, 1, canopen);
    EXPECT_TRUE(control(1));  // with the inverse latch, the rest state is ON
}

TEST_F(Ax130751Relay, DisabledRelayThatKeepsItsStateNeedsNoControl) {
    verifies<req::AOR_RELAY_024, req::AOR_RELAY_027>();
    connect(0x2280, 1);
    set8(0x2282, 1, 5);  // response 5: enabled while the input is OFF; otherwise the relay keeps its state
    EXPECT_TRUE(control(1));
    extra(1, 100);
    set8(0x2260, 1, not_used);
    pass(2);
    EXPECT_TRUE(relay_on()) << "enable comes before control";
    extra(1, 0);
    EXPECT_FALSE(relay_on()) << "enabled, but without a control";
}

TEST_F(Ax130751Relay, UnusedOverrideIsNotReadAsOff) {
    verifies<req::AOR_RELAY_016, req::AOR_T12>();
    set8(0x2290, 1, not_used);
    set8(0x2292, 1, 1);  // override response 1: the override works while its input is OFF
    set8(0x2293, 1, 1);
    EXPECT_FALSE(control(0));
    connect(0x2290, 2);
    EXPECT_TRUE(relay_on());
}

TEST_F(Ax130751Relay, RelayWithPolarityNotImplementedIsOffEvenWhenOverridden) {
    verifies<req::AOR_RELAY_002, req::AOR_T10>();
    connect(0x2290, 2);
    set8(0x2293, 1, 1);
    extra(2, 100);
    EXPECT_TRUE(relay_on()) << "overridden";
    set8(0x2242, 1, 0);
    pass(1);
    EXPECT_FALSE(relay_on());
}

}  // namespace canproof::test
