// SPDX-License-Identifier: Apache-2.0
// Tests that an enable or override input that is in error has no effect, whatever effect it had before. The fault mode
// then determines the output (AX130751 manual, 1.3, Tables 7 to 9; 1.2, Table 2). The tests try every response of the
// input, with ON and with OFF as the last state of the input.
#include <gtest/gtest.h>

#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751InputInError : public Ax130751Blocks {
  protected:
    /// Connects an input of output 1 to 2500h:1 (EC Extra Received Process Value), which RPDO2 must set at least every
    /// 100 ms.
    void watch_input(std::uint16_t source_index) {
        extra_as_percent(1);
        set8(source_index, 1, canopen);
        set8(static_cast<std::uint16_t>(source_index + 1), 1, 4);  // number 4 of the CANopen messages is 2500h:1
        set8(0x1601, 0, 0);
        set32(0x1601, 1, 0x25000110);
        set8(0x1601, 0, 1);
        set32(0x1401, 1, 0x4000037F);
        set16(0x1401, 5, 100);
        start();
    }
    /// Sets the input to 0 % or 100 %, then lets its RPDO time out.
    void lose_input(bool on) {
        send(on ? "37F#6400" : "37F#0000");
        pass(2);
        pass(150);
    }
    /// For each value of object `response_index` and for each last state of the input: lets the input time out and
    /// calls `check`.
    template <typename Check>
    void in_each_response(std::uint16_t response_index, int responses, const Check& check) {
        for (int response = 0; response < responses; ++response) {
            for (const bool on : {false, true}) {
                SCOPED_TRACE(fmt::format("{:04X}h = {}, last {}", response_index, response, on ? "ON" : "OFF"));
                set8(response_index, 1, response);
                lose_input(on);
                check();
            }
        }
    }
};

}  // namespace

TEST_F(Ax130751InputInError, AnalogueOutputTakesItsFaultValueWhenItsEnableInputIsInError) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x7341, 1, 1500);
    watch_input(0x2350);
    command(1, 4000);
    in_each_response(0x2352, 6, [this] { EXPECT_FLOAT_EQ(volts(1), 1.5F); });
}

TEST_F(Ax130751InputInError, AnalogueOutputTakesItsFaultValueWhenItsOverrideInputIsInError) {
    verifies<req::AOR_OUT_029, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x2300, 1, 3000);
    set16(0x7341, 1, 1500);
    watch_input(0x2360);
    command(1, 4000);
    in_each_response(0x2362, 2, [this] { EXPECT_FLOAT_EQ(volts(1), 1.5F); });
}

TEST_F(Ax130751InputInError, InputIsInErrorAtEachOfTheFourMappingPositionsOfItsOverdueRpdo) {
    verifies<req::AOR_SRC_004, req::AOR_OUT_011>();
    no_ramps(1);
    set16(0x2300, 1, 3000);
    set16(0x7341, 1, 1500);
    watch_input(0x2360);
    command(1, 4000);
    for (std::uint8_t place = 1; place <= 4; ++place) {
        SCOPED_TRACE(place);
        set32(0x1401, 1, 0xC000037F);  // 1401h:1 COB-ID of RPDO2: not valid while its mapping changes
        set8(0x1601, 0, 0);
        for (std::uint8_t sub = 1; sub <= 4; ++sub) {
            const unsigned element = sub == place ? 1U : sub + 1U;
            set32(0x1601, sub, static_cast<int>(0x25000010U | element << 8U));
        }
        set8(0x1601, 0, 4);
        set32(0x1401, 1, 0x4000037F);
        send("37F#6400640064006400");
        pass(2);
        EXPECT_FLOAT_EQ(volts(1), 3.0F) << "overridden";
        pass(150);
        EXPECT_FLOAT_EQ(volts(1), 1.5F) << "the override is in error";
    }
}

// The last command then drives the output again, and nothing monitors it until the RPDO comes.
TEST_F(Ax130751InputInError, ErrorOfAnRpdoEndsWithAWriteOfItsParametersAndWithAResetOfTheCommunication) {
    verifies<req::AOR_SRC_004, req::AOR_PDO_009>();
    no_ramps(1);
    set16(0x7341, 1, 1500);
    for (const bool resets : {false, true}) {
        SCOPED_TRACE(resets);
        set16(0x1400, 5, 100);
        send("27F#A00F000000");  // RPDO1 commands 4 V
        pass(2);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
        pass(150);
        EXPECT_FLOAT_EQ(volts(1), 1.5F);
        EXPECT_EQ(get8(0x1001, 0), 1);
        if (resets) {
            send("000#827F");
            start();
        } else {
            set16(0x1400, 5, 90);
        }
        pass(2);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
        EXPECT_EQ(get8(0x1001, 0), 0);
        pass(500);
        EXPECT_FLOAT_EQ(volts(1), 4.0F);
    }
}

TEST_F(Ax130751InputInError, DigitalOutputTakesItsFaultStateWhenItsEnableInputIsInError) {
    verifies<req::AOR_OUT_033, req::AOR_DO_005>();
    set16(0x6310, 1, 1020);
    watch_input(0x2350);
    set8(0x6220, 1, 1);
    for (const bool state : {true, false}) {
        set8(0x6260, 1, state ? 1 : 0);
        in_each_response(0x2352, 6, [this, state] { EXPECT_EQ(is_on(1), state); });
    }
}

TEST_F(Ax130751InputInError, DigitalOutputTakesItsFaultStateWhenItsOverrideInputIsInError) {
    verifies<req::AOR_OUT_033, req::AOR_DO_005>();
    set16(0x6310, 1, 1020);
    watch_input(0x2360);
    set8(0x6220, 1, 1);
    for (const bool state : {true, false}) {
        set16(0x2300, 1, state ? 0 : 1);  // the override value is the opposite of the fault state
        set8(0x6260, 1, state ? 1 : 0);
        in_each_response(0x2362, 2, [this, state] { EXPECT_EQ(is_on(1), state); });
    }
}

}  // namespace canproof::test
