// SPDX-License-Identifier: Apache-2.0
// LEDs of the CAN-CBX-AO412 (manual, 3.2), node 3.
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class CbxLeds : public CbxTest {
  protected:
    void SetUp() override {
        CbxTest::SetUp();
        pass(4000);  // the pattern of each LED has already run for 4 s when it is sampled
    }
    /// Samples an LED in the middle of each 100 ms. Returns one character per sample: # lit, . dark.
    std::string watch(bool generated::cbx_ao412::Outputs::*led, int tenths) {
        std::string seen;
        pass(50);
        for (int i = 0; i < tenths; ++i) {
            seen += device->outputs().*led ? '#' : '.';
            pass(100);
        }
        pass(50);
        return seen;
    }
    /// Returns whether `seen` repeats the pattern `round`. The first character of `seen` may be anywhere in the
    /// pattern.
    static bool repeats(const std::string& seen, const std::string& round) {
        std::string endless;
        while (endless.size() < seen.size() + round.size()) {
            endless += round;
        }
        return endless.find(seen) != std::string::npos;
    }
    static constexpr auto e = &generated::cbx_ao412::Outputs::led_e;
    static constexpr auto s = &generated::cbx_ao412::Outputs::led_s;
    static constexpr auto m = &generated::cbx_ao412::Outputs::led_m;
    static constexpr auto p = &generated::cbx_ao412::Outputs::led_p;
};

// The patterns of section 3.2.1, one character for each 100 ms.
const std::string blinking = "##..";
const std::string one_flash = "##..............";          // one flash of 200 ms, then 1400 ms off
const std::string two_flashes = "##..##..........";        // two flashes of 200 ms, 200 ms apart, then 1000 ms off
const std::string three_flashes = "##..##..##..........";  // three flashes of 200 ms, 200 ms apart, then 1000 ms off
const std::string lit(40, '#');
const std::string dark(40, '.');

}  // namespace

TEST_F(CbxLeds, StatusLedFollowsTheNmtState) {
    verifies<req::AO4_LED_001, req::AO4_LED_005, req::AO4_LED_008, req::AO4_T7, req::AO4_T5, req::AO4_E_INDICATOR,
             req::AO4_S_LED_S>();
    EXPECT_TRUE(repeats(watch(s, 40), blinking));
    send("000#0103");
    EXPECT_EQ(watch(s, 40), lit);
    send("000#0203");
    EXPECT_TRUE(repeats(watch(s, 40), one_flash));
}

/// If LED S blinked, it would be dark from 200 to 400 ms after power-on.
TEST_F(CbxLeds, StatusLedShowsASelfStartAtOnce) {
    verifies<req::AO4_LED_001, req::AO4_START_001>();
    write("603#23801F0008000000");
    write("603#2B911F012C010000");  // 1F91h:1 self-start delay: 300 ms
    write("603#2310100173617665");
    now = Instant{};
    power_on();
    pass(299);
    EXPECT_FALSE(device->outputs().led_s);
    pass(1);
    EXPECT_TRUE(device->outputs().led_s);
}

TEST_F(CbxLeds, CanErrorLedShowsTheMostSevereCondition) {
    verifies<req::AO4_LED_002, req::AO4_LED_008, req::AO4_T6, req::AO4_S_LED_E>();
    EXPECT_EQ(watch(e, 40), dark);
    inputs.can_state = 1;
    set_inputs();
    EXPECT_TRUE(repeats(watch(e, 40), one_flash));
    inputs.can_state = 2;
    set_inputs();
    EXPECT_TRUE(repeats(watch(e, 40), one_flash));
    write("603#23161001C8003100");
    send("731#05");
    pass(300);
    EXPECT_TRUE(repeats(watch(e, 40), two_flashes));
    inputs.can_state = 0;
    set_inputs();
    EXPECT_TRUE(repeats(watch(e, 40), two_flashes));
    send("731#05");
    write("603#2316100100000000");
    EXPECT_EQ(watch(e, 40), dark);
    write("603#2B0C100064000000");  // 100Ch guard time: 100 ms
    write("603#2F0D100002000000");  // 100Dh life time factor: 2
    send("703#R1");
    pass(199);
    EXPECT_FALSE(device->outputs().led_e);
    pass(1);
    EXPECT_TRUE(repeats(watch(e, 40), two_flashes));
    send("603#2B0C100000000000");  // guard time 0 ends the guarding error
    EXPECT_EQ(watch(e, 40), dark);
    inputs.can_state = 3;
    set_inputs();
    EXPECT_EQ(watch(e, 40), lit);
}

TEST_F(CbxLeds, ErrorLedShowsOverrunAndSoftwareFault) {
    verifies<req::AO4_LED_003, req::AO4_LED_007, req::AO4_T8, req::AO4_S_LED_M, req::AO4_S_CAN_OVERRUN>();
    EXPECT_EQ(watch(m, 40), dark);
    inputs.can_overrun = true;
    set_inputs();
    EXPECT_EQ(watch(m, 40), lit);
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
    inputs.can_overrun = false;
    inputs.internal_fault = false;
    set_inputs();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));  // LED M keeps showing the two flashes until the next reset
    send("000#8103");
    EXPECT_EQ(watch(m, 40), dark);
}

TEST_F(CbxLeds, ErrorLedShowsAHardwareFailureUntilTheReset) {
    verifies<req::AO4_LED_003, req::AO4_LED_007, req::AO4_T8, req::AO4_S_HARDWARE_FAULT>();
    inputs.hardware_fault = true;
    set_inputs();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
    send("000#8103");
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));  // the hardware failure is still active
    inputs.hardware_fault = false;
    set_inputs();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
    send("000#8103");
    EXPECT_EQ(watch(m, 40), dark);
}

TEST_F(CbxLeds, ErrorLedShowsCorruptStoredParameters) {
    verifies<req::AO4_LED_003>();
    write("603#2310100173617665");
    memory.bytes()[40] ^= 0x01;
    power_on();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
}

TEST_F(CbxLeds, PowerLedIsOnWhileTheApplicationRuns) {
    verifies<req::AO4_LED_004, req::AO4_T9, req::AO4_S_LED_P>();
    EXPECT_EQ(watch(p, 40), lit);
    inputs.switch_high = 8;
    power_on();
    EXPECT_EQ(watch(p, 40), dark);
}

TEST_F(CbxLeds, StatusAndCanErrorLedsShowAnInvalidNodeId) {
    verifies<req::AO4_LED_001, req::AO4_LED_002, req::AO4_SW_002, req::AO4_T6, req::AO4_T7>();
    inputs.switch_high = 8;  // node-ID 83h, which is invalid
    power_on();
    EXPECT_TRUE(repeats(watch(s, 40), three_flashes));
    EXPECT_EQ(watch(e, 40), lit);
}

TEST_F(CbxLeds, ErrorLedShowsAnInternalFailureEvenWithAnInvalidNodeId) {
    verifies<req::AO4_LED_003, req::AO4_LED_007, req::AO4_SW_002>();
    inputs.switch_high = 8;  // node-ID 83h, which is invalid
    power_on();
    EXPECT_EQ(watch(m, 40), dark);
    inputs.internal_fault = true;
    EXPECT_EQ(set_inputs(), Frames{});
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
    for (int output = 1; output <= 4; ++output) {
        EXPECT_EQ(volts(output), 0.0F);
    }
    inputs.internal_fault = false;
    EXPECT_EQ(set_inputs(), Frames{});
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes)) << "until the next reset";
    EXPECT_EQ(power_on(), Frames{});
    EXPECT_EQ(watch(m, 40), dark);
    inputs.internal_fault = true;
    EXPECT_EQ(power_on(), Frames{});  // the failure is present before power-on
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
}

TEST_F(CbxLeds, RedAndGreenLedsFlashAlternately) {
    verifies<req::AO4_LED_006>();
    // In stopped, the green LED S flashes once per 1.6 s. At the warning limit, the red LED E flashes with the same
    // pattern.
    send("000#0203");
    inputs.can_state = 1;
    set_inputs();
    for (int i = 0; i < 320; ++i) {
        EXPECT_FALSE(device->outputs().led_s && device->outputs().led_e);
        pass(10);
    }
}

TEST_F(CbxLeds, InternalFaultBeforeAPowerOnWithAnInvalidNodeIdIsNotShownAfterIt) {
    verifies<req::AO4_SW_002, req::CO_NMT_001>();
    inputs.internal_fault = true;
    set_inputs();
    EXPECT_TRUE(repeats(watch(m, 40), two_flashes));
    inputs.internal_fault = false;
    inputs.switch_high = 0;
    inputs.switch_low = 0;
    device->power_on(inputs, now);
    EXPECT_FALSE(repeats(watch(m, 40), two_flashes));
}

}  // namespace canproof::test
