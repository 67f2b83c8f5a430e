// SPDX-License-Identifier: Apache-2.0
// Tests the inputs that stop an output of the AX130751 whatever its control input is: enable, override and unlatch
// (manual, 1.2 to 1.4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751Interlock : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        extra_as_percent(1);
        extra_as_percent(2);
    }
    void choose(std::uint16_t source_index, int output, int source, int number) {
        set8(source_index, output, source);
        set8(static_cast<std::uint16_t>(source_index + 1), output, number);
        pass(1);
    }
    /// Connects an input to extra received value `number` (2500h).
    void connect(std::uint16_t source_index, int output, int number) {
        choose(source_index, output, canopen, 3 + number);
    }
    /// Makes output 1 a voltage output at 4 V.
    void make_voltage() {
        no_ramps(1);
        command(1, 4000);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
    }
    /// Makes output 1 a digital output that is ON. RPDO4, which sets 6220h:1, gets a time-out of 50 ms.
    void make_digital() {
        set16(0x6310, 1, 1020);
        set16(0x1403, 5, 50);
        start();
        send("57F#0100");
        pass(2);
        EXPECT_TRUE(is_on(1));
    }
    void make_relay() {
        set8(0x6220, 3, 1);
        pass(1);
        EXPECT_TRUE(relay_on());
    }
    /// Sets a time-out of 100 ms for RPDO2, which maps 2500h:1 (EC Extra Received Process Value) to 2500h:3.
    void watch_extra() {
        set32(0x1401, 1, 0x4000037F);
        set16(0x1401, 5, 100);
        start();
    }
};

}  // namespace

// Section 1.3: an enable is a safety interlock
TEST_F(Ax130751Interlock, OutputGoesOffWhenItsEnableSourceHasNoValue) {
    verifies<req::AOR_OUT_028, req::AOR_OUT_008>();
    for (int response = 0; response < 6; ++response) {
        for (const Choice& choice : without_value) {
            SCOPED_TRACE(fmt::format("2352h = {}, source {}, number {}", response, choice.source, choice.number));
            set8(0x2352, 1, response);
            make_voltage();
            set16(0x2331, 1, 1000);  // sets a ramp, which must not delay the shutdown
            choose(0x2350, 1, choice.source, choice.number);
            EXPECT_FLOAT_EQ(volts(1), 0.0F);
            EXPECT_EQ(get16(0x7330, 1), 0);
            set8(0x2350, 1, not_used);
            pass(1);
            EXPECT_FLOAT_EQ(volts(1), 4.0F) << "source 0 is ignored";
        }
    }
}

TEST_F(Ax130751Interlock, DigitalOutputGoesOffWhenItsEnableSourceIsDisabled) {
    verifies<req::AOR_OUT_028>();
    make_digital();
    choose(0x3010, 0, canopen, 4);  // table 1 reads 2500h:1 (EC Extra Received Process Value)
    choose(0x2350, 1, lookup_source, 1);
    extra(1, 0);
    EXPECT_TRUE(is_on(1)) << "enabled while OFF";
    set8(0x3010, 0, not_used);
    pass(1);
    EXPECT_FALSE(is_on(1));
    set8(0x6250, 1, 0);  // fault mode 0 would keep the state in a fault; a source without a value is no fault
    pass(5);
    EXPECT_FALSE(is_on(1));
}

TEST_F(Ax130751Interlock, OutputGoesOffWhenItsOverrideSourceHasNoValue) {
    verifies<req::AOR_OUT_028, req::AOR_OUT_008>();
    set16(0x2300, 1, 3000);
    for (const int response : {0, 1}) {
        for (const Choice& choice : without_value) {
            SCOPED_TRACE(fmt::format("2362h = {}, source {}, number {}", response, choice.source, choice.number));
            set8(0x2362, 1, response);
            make_voltage();
            choose(0x2360, 1, choice.source, choice.number);
            EXPECT_FLOAT_EQ(volts(1), 0.0F);
            set8(0x2360, 1, not_used);
            pass(1);
            EXPECT_FLOAT_EQ(volts(1), 4.0F);
        }
    }
}

TEST_F(Ax130751Interlock, DisabledDigitalOutputStaysOffWhenItsControlIsLost) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_033, req::AOR_OUT_007, req::AOR_DO_005>();
    make_digital();
    connect(0x2350, 1, 1);
    send("57F#0100");
    extra(1, 100);
    EXPECT_FALSE(is_on(1)) << "disabled";
    pass(60);
    EXPECT_FALSE(is_on(1)) << "6260h is ON as shipped";
    extra(1, 0);
    EXPECT_TRUE(is_on(1)) << "enabled: the fault state applies";
}

TEST_F(Ax130751Interlock, DisabledAnalogueOutputShutsOffWhenItsControlIsLost) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_011>();
    no_ramps(1);
    connect(0x2350, 1, 1);
    set8(0x6340, 1, 0);  // fault mode 0: the output keeps its last value
    set16(0x1400, 5, 50);
    start();
    send("27F#A00F000000");  // commands 4 V
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 4.0F);
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
}

TEST_F(Ax130751Interlock, ValidOverrideActsOnAnOutputFrozenByAFault) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_010>();
    no_ramps(1);
    connect(0x2360, 1, 1);
    set16(0x2300, 1, 1000);
    set8(0x6340, 1, 0);
    set16(0x1400, 5, 50);
    start();
    send("27F#A00F000000");
    pass(60);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "maintains its state";
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);
}

TEST_F(Ax130751Interlock, OverrideValueIsNotUsedWhileTheOverrideInputIsInError) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_033, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x2300, 1, 3000);
    set16(0x7341, 1, 1500);
    connect(0x2360, 1, 1);
    connect(0x2350, 1, 2);
    set8(0x1601, 0, 0);
    set32(0x1601, 1, 0x25000110);  // RPDO2 carries 2500h:1 alone
    set8(0x1601, 0, 1);
    set32(0x1401, 1, 0x4000037F);
    set16(0x1401, 5, 100);
    start();
    send("37F#6400");
    command(1, 4000);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "overridden";
    pass(150);
    EXPECT_FLOAT_EQ(volts(1), 1.5F) << "no longer: 7341h";
    extra(2, 100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "the enable is valid";
}

TEST_F(Ax130751Interlock, RelayGoesOffWhenItsEnableSourceHasNoValue) {
    verifies<req::AOR_RELAY_018, req::AOR_RELAY_016>();
    for (int response = 0; response < 6; ++response) {
        for (const Choice& choice : without_value) {
            SCOPED_TRACE(fmt::format("2282h = {}, source {}, number {}", response, choice.source, choice.number));
            set8(0x2282, 1, response);
            make_relay();
            set32(0x22A2, 1, 1000);  // sets a delay, which must not delay the shutdown
            set8(0x22A0, 1, 1);
            choose(0x2280, 1, choice.source, choice.number);
            EXPECT_FALSE(relay_on());
            set8(0x22A0, 1, 0);
            set8(0x2280, 1, not_used);
            pass(1);
            EXPECT_TRUE(relay_on()) << "source 0 is ignored";
        }
    }
}

TEST_F(Ax130751Interlock, RelayGoesOffWhenItsOverrideOrUnlatchSourceHasNoValue) {
    verifies<req::AOR_RELAY_018, req::AOR_RELAY_016, req::AOR_RELAY_028>();
    set8(0x2293, 1, 1);  // override state ON
    for (const Choice& choice : without_value) {
        SCOPED_TRACE(fmt::format("source {}, number {}", choice.source, choice.number));
        make_relay();
        choose(0x2290, 1, choice.source, choice.number);
        EXPECT_FALSE(relay_on()) << "override";
        set8(0x2290, 1, not_used);
        make_relay();
        choose(0x2270, 1, choice.source, choice.number);
        EXPECT_TRUE(relay_on()) << "the unlatch input means nothing to normal logic";
        set8(0x2242, 1, 3);  // the latch is ON, because the control of make_relay() is ON
        pass(1);
        EXPECT_FALSE(relay_on()) << "unlatch of the latch";
        set8(0x2242, 1, 4);  // the rest state of the inverse latch is ON
        pass(1);
        EXPECT_FALSE(relay_on()) << "unlatch of the inverse latch";
        set8(0x2270, 1, not_used);
        pass(1);
        EXPECT_TRUE(relay_on());
        set8(0x2242, 1, 1);
    }
}

TEST_F(Ax130751Interlock, OverrideInputInErrorPutsTheRelayOff) {
    verifies<req::AOR_RELAY_011>();
    watch_extra();
    set8(0x2293, 1, 1);
    connect(0x2290, 1, 1);
    send("37F#640000000000");
    pass(2);
    EXPECT_TRUE(relay_on()) << "overridden";
    pass(110);
    EXPECT_FALSE(relay_on());
}

// Section 1.4, with the names of the pins of section 2.1: in state OFF the coil carries current; without supply it
// has none.
TEST_F(Ax130751Interlock, RelayWithoutSupplyClosesTheContactNc) {
    verifies<req::AOR_RELAY_019, req::AOR_RELAY_001, req::AOR_DIAG_008>();
    const auto contact = [this](float supplied) {
        inputs.supply = supplied;
        set_inputs();
        pass(1);
        EXPECT_NE(device->outputs().relay_nc, device->outputs().relay_no);
        return device->outputs().relay_nc;
    };
    EXPECT_FALSE(contact(24.0F)) << "OFF";
    EXPECT_TRUE(contact(0.0F));
    EXPECT_TRUE(contact(6.9F));
    EXPECT_FALSE(contact(7.0F)) << "an under-voltage fault: OFF";
    EXPECT_FALSE(contact(39.0F));
    EXPECT_TRUE(contact(39.5F));
    EXPECT_FALSE(contact(24.0F));
    EXPECT_TRUE(contact(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(contact(24.0F));
    send("000#807F");
    EXPECT_FALSE(contact(24.0F));
    EXPECT_TRUE(contact(1.0F)) << "in every state";
    power_on();
    EXPECT_TRUE(device->outputs().relay_nc) << "power-on without a supply";
    EXPECT_FALSE(contact(24.0F));
}

// Sections 1.8 and 3.4.86: outputs work only in NMT state operational. 5555h (Start in Operational Mode) lets a unit
// without a master enter operational.
TEST_F(Ax130751Interlock, OutputsRunInOperationalOnly) {
    verifies<req::AOR_OUT_026, req::AOR_OUT_041, req::AOR_OUT_007>();
    make_voltage();
    make_relay();
    set16(0x6310, 2, 1020);
    set8(0x2241, 2, 1);  // polarity 1, inverse: ON without a command
    set16(0x2300, 1, 3000);
    pass(1);
    EXPECT_TRUE(is_on(2));
    for (const char* command : {"000#807F", "000#027F"}) {  // pre-operational, stopped
        SCOPED_TRACE(command);
        send(command);
        pass(1);
        EXPECT_FLOAT_EQ(volts(1), 0.0F);
        EXPECT_FALSE(is_on(2));
        EXPECT_FALSE(relay_on());
        EXPECT_EQ(device->objects().read(0x7330, 1), 0U);
        EXPECT_EQ(device->objects().read(0x2370, 1), 0U);
        pass(500);
        EXPECT_FLOAT_EQ(volts(1), 0.0F);
        start();
        pass(1);
        EXPECT_FLOAT_EQ(volts(1), 4.0F) << "takes up its input again";
        EXPECT_TRUE(is_on(2));
        EXPECT_TRUE(relay_on());
    }
    send("000#807F");
    connect(0x2360, 1, 1);
    set8(0x2293, 1, 1);
    connect(0x2290, 1, 1);
    extra(1, 100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "no override changes it";
    EXPECT_TRUE(device->outputs().relay_no);
}

TEST_F(Ax130751Interlock, SecondHeartbeatProducerThatFallsSilentAlsoShutsTheOutputsOff) {
    verifies<req::AOR_OUT_026, req::AOR_ERR_006>();
    no_ramps(1);
    set16(0x7341, 1, 3000);
    set8(0x1029, 1, 0);
    set32(0x1016, 1, 0x00210064);  // monitors nodes 21h and 22h, 100 ms each
    set32(0x1016, 2, 0x00220064);
    start();
    send("721#05");
    pass(101);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "pre-operational";
    start();  // the master starts the device although node 21h is silent
    send("722#05");
    pass(50);
    EXPECT_FLOAT_EQ(volts(1), 3.0F) << "7341h: its control is in error";
    pass(51);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "pre-operational again";
}

TEST_F(Ax130751Interlock, LookupTableRunsInPreOperational) {
    verifies<req::AOR_OUT_026>();
    send("000#807F");
    choose(0x3010, 0, canopen, 4);
    extra(1, 70);
    EXPECT_EQ(get16(0x3018, 0), 70);
}

TEST_F(Ax130751Interlock, RampStartsFromOffWhenTheNodeIsStartedAgain) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_045>();
    command(1, 5000);
    pass(1000);
    EXPECT_FLOAT_EQ(volts(1), 5.0F);
    send("000#807F");
    pass(1);
    start();
    pass(1 + 200);
    EXPECT_FLOAT_EQ(volts(1), 1.0F);  // 1 V after 200 ms: the ramp rises by 5 V per second
}

TEST_F(Ax130751Interlock, ResetCommunicationPutsOutputsAndRelayOff) {
    verifies<req::AOR_OUT_026, req::AOR_OUT_041>();
    make_voltage();
    make_relay();
    send("000#827F");
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 0.0F);
    EXPECT_FALSE(relay_on());
    start();
    pass(1);
    EXPECT_FLOAT_EQ(volts(1), 4.0F) << "7300h is as it was";
}

// AX130751, 3.2.13
TEST_F(Ax130751Interlock, CommunicationFaultThatEndsOperationalPutsTheOutputsOff) {
    verifies<req::AOR_OUT_026, req::AOR_ERR_006>();
    no_ramps(1);
    set16(0x7341, 1, 1500);
    set16(0x1400, 5, 50);
    for (const int behaviour : {0, 1, 2}) {
        SCOPED_TRACE(behaviour);
        set8(0x1029, 1, behaviour);
        send("27F#A00F000001");  // 4 V, relay ON
        pass(2);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
        EXPECT_TRUE(relay_on());
        pass(60);
        EXPECT_FLOAT_EQ(volts(1), behaviour == 1 ? 1.5F : 0.0F) << "7341h in operational";
        EXPECT_FALSE(relay_on());
        start();
        send("27F#A00F000001");
    }
}

TEST_F(Ax130751Interlock, OutputsRunAfterTheSelfStart) {
    verifies<req::AOR_OUT_041, req::AOR_START_001, req::AOR_START_005, req::AOR_OD_5555>();
    no_ramps(1);
    set8(0x2342, 1, 0);
    set16(0x7321, 1, 2000);  // 7321h:1 (AO Output Scaling 1 FV): 2 V at a control value of 0
    store();
    power_on();
    pass(100);
    EXPECT_FLOAT_EQ(volts(1), 0.0F) << "waits for the master";
    set8(0x5555, 0, 1);
    store();
    power_on();
    pass(2);
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_FLOAT_EQ(volts(1), 2.0F);
}

}  // namespace canproof::test
