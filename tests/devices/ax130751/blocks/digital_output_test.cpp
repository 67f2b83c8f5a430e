// SPDX-License-Identifier: Apache-2.0
// Tests the digital output block of the AX130751 (manual, 1.2) with the polarities of Table 1.
#include "devices/ax130751/firmware/digital_output.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

using Row = std::array<SwitchDrive, 2>;
constexpr SwitchPolarity normal{Row{SwitchDrive::off, SwitchDrive::on}, Row{SwitchDrive::off, SwitchDrive::on}};
constexpr SwitchPolarity inverse{Row{SwitchDrive::on, SwitchDrive::off}, Row{SwitchDrive::on, SwitchDrive::off}};
constexpr SwitchPolarity latched{Row{SwitchDrive::keep, SwitchDrive::change},
                                 Row{SwitchDrive::keep, SwitchDrive::keep}};
constexpr SwitchPolarity blinking{Row{SwitchDrive::off, SwitchDrive::blink}, Row{SwitchDrive::off, SwitchDrive::blink}};
constexpr auto control = OutputDrive::control;

/// Runs an output. Control and output are texts with one character per millisecond: # ON, . OFF.
class DigitalOutputTest : public testing::Test {
  protected:
    std::string run(const std::string& controls, const SwitchPolarity& polarity, OutputDrive drive = control,
                    bool override_state = false, bool fault_state = false) {
        std::string seen;
        for (const char c : controls) {
            const DigitalDemand demand{c == '#', override_state, fault_state};
            seen += output.advance(drive, demand, polarity, blink, now).drive ? '#' : '.';
            now = now + milliseconds(1);
        }
        return seen;
    }
    bool logic(bool on, const SwitchPolarity& polarity) {
        return output.advance(control, {on, false, false}, polarity, blink, now).logic;
    }

    DigitalOutput output;
    Duration blink{milliseconds(3)};
    Instant now{};
};

}  // namespace

TEST_F(DigitalOutputTest, OutputFollowsTheControlWithNormalPolarityAndOpposesItWithInverse) {
    verifies<req::AOR_DO_003, req::AOR_DO_018>();
    EXPECT_EQ(run("..##.#", normal), "..##.#");
    EXPECT_EQ(run("..##.#", inverse), "##..#.");
}

TEST_F(DigitalOutputTest, LatchedOutputChangesAtEachRisingEdge) {
    verifies<req::AOR_DO_019>();
    EXPECT_EQ(run("..##..#..#.", latched), "..####...##");
}

TEST_F(DigitalOutputTest, BlinkingOutputStartsWithOnAndBlinksWhileItsControlIsOn) {
    verifies<req::AOR_DO_004, req::AOR_DO_010, req::AOR_DO_014, req::AOR_DO_020>();
    EXPECT_EQ(run("..##########..###", blinking), "..###...###...###");
    blink = milliseconds(0);
    EXPECT_EQ(run(".#####", blinking), ".#####");
}

TEST_F(DigitalOutputTest, TimeOfTheNextBlinkChangeIsReported) {
    verifies<req::AOR_DO_004, req::AOR_DO_010>();
    EXPECT_EQ(output.next_change(), never);
    run("#", blinking);  // the output goes ON at 0 ms, for 3 ms
    EXPECT_EQ(output.next_change().us, 3000U);
    run("#", blinking, OutputDrive::override_value, true);
    EXPECT_EQ(output.next_change(), never) << "overridden it does not blink";
    run("##", blinking);  // runs at 2 and 3 ms; the output begins to blink again with ON at 2 ms
    EXPECT_EQ(output.next_change().us, 5000U);
    run("#", normal);
    EXPECT_EQ(output.next_change(), never);
}

TEST_F(DigitalOutputTest, LogicStateIgnoresThePolarity) {
    verifies<req::AOR_DO_007>();
    EXPECT_TRUE(logic(true, inverse));
    EXPECT_FALSE(logic(false, inverse));
}

TEST_F(DigitalOutputTest, PolarityAppliesToTheControlButNotToOverrideFaultOrShutOff) {
    verifies<req::AOR_DO_012, req::AOR_DO_005>();
    EXPECT_EQ(run(".", inverse), "#");
    EXPECT_EQ(run("..", inverse, OutputDrive::shut_off), "..");
    EXPECT_EQ(run(".", inverse, OutputDrive::ramp_off), ".");
    EXPECT_EQ(run(".", inverse, OutputDrive::shutdown), ".");
    EXPECT_EQ(run(".", inverse, OutputDrive::override_value, true), "#");
    EXPECT_EQ(run(".", inverse, OutputDrive::override_value, false), ".");
    EXPECT_EQ(run(".", inverse, OutputDrive::fault_value, false, true), "#");
    EXPECT_EQ(run(".", inverse, OutputDrive::fault_value, true, false), ".");
}

TEST_F(DigitalOutputTest, LogicStateIsThatOfAnActiveOverrideFaultOrShutOff) {
    verifies<req::AOR_DO_007, req::AOR_DO_006, req::AOR_DO_011, req::AOR_DO_005>();
    const auto logic_of = [this](OutputDrive drive, bool override_state, bool fault_state) {
        return output.advance(drive, {true, override_state, fault_state}, inverse, blink, now).logic;
    };
    EXPECT_TRUE(logic_of(OutputDrive::override_value, true, false));
    EXPECT_FALSE(logic_of(OutputDrive::override_value, false, true));
    EXPECT_TRUE(logic_of(OutputDrive::fault_value, false, true));
    EXPECT_FALSE(logic_of(OutputDrive::fault_value, true, false));
    for (const auto drive : {OutputDrive::shut_off, OutputDrive::ramp_off, OutputDrive::shutdown}) {
        EXPECT_TRUE(logic(true, inverse));
        EXPECT_FALSE(logic_of(drive, true, true));
        EXPECT_FALSE(logic_of(OutputDrive::keep, true, true)) << "as before";
    }
    EXPECT_TRUE(logic(true, inverse));
    EXPECT_TRUE(logic_of(OutputDrive::keep, false, false)) << "as before";
}

TEST_F(DigitalOutputTest, KeepResponseFreezesTheOutputState) {
    verifies<req::AOR_DO_015, req::AOR_DO_016>();
    EXPECT_EQ(run("#", normal), "#");
    EXPECT_EQ(run(".#.", normal, OutputDrive::keep), "###");
    EXPECT_EQ(run(".", normal), ".");
    EXPECT_EQ(run("#", normal, OutputDrive::keep), ".");
}

TEST_F(DigitalOutputTest, LatchIsKeptAndControlEdgesAreIgnoredWhileTheControlIsOverruled) {
    verifies<req::AOR_DO_008, req::AOR_DO_013, req::AOR_DO_021>();
    EXPECT_EQ(run(".#.", latched), ".##");
    EXPECT_EQ(run(".#.#", latched, OutputDrive::shut_off), "....");
    EXPECT_EQ(run("#.", latched), "##") << "two edges passed by, the control is still ON";
    EXPECT_EQ(run("#", latched), ".");
    EXPECT_EQ(run(".#.#", latched, OutputDrive::keep), "....");
    EXPECT_EQ(run("#.", latched), "..") << "kept, and an edge passed by";
    EXPECT_EQ(run("#", latched), "#");
}

}  // namespace canproof::test
