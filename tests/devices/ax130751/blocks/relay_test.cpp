// SPDX-License-Identifier: Apache-2.0
// Tests the relay block of the AX130751 (manual, 1.4) with the polarities of Table 10.
#include "devices/ax130751/firmware/relay.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

using Row = std::array<SwitchDrive, 2>;
constexpr auto off = SwitchDrive::off;
constexpr auto on = SwitchDrive::on;
constexpr auto keep = SwitchDrive::keep;
constexpr auto change = SwitchDrive::change;
constexpr auto blink = SwitchDrive::blink;
constexpr RelayPolarity not_implemented{{Row{off, off}, Row{off, off}}, UnlatchEffect::ignored};
constexpr RelayPolarity normal{{Row{off, on}, Row{off, on}}, UnlatchEffect::ignored};
constexpr RelayPolarity inverse{{Row{on, off}, Row{on, off}}, UnlatchEffect::ignored};
constexpr RelayPolarity latched{{Row{keep, change}, Row{keep, keep}}, UnlatchEffect::to_off};
constexpr RelayPolarity never_unlatched{{Row{keep, change}, Row{keep, keep}}, UnlatchEffect::ignored};
constexpr RelayPolarity inverse_latched{{Row{keep, keep}, Row{change, keep}}, UnlatchEffect::to_on};
constexpr RelayPolarity toggle{{Row{off, blink}, Row{off, blink}}, UnlatchEffect::ignored};

/// Runs a relay. Its inputs and its state are texts with one character per millisecond: # ON, . OFF.
class RelayTest : public testing::Test {
  protected:
    std::string run(const std::string& controls, const RelayPolarity& polarity, const std::string& unlatch = "",
                    OutputDrive drive = OutputDrive::control, bool override_state = false) {
        std::string seen;
        for (std::size_t i = 0; i < controls.size(); ++i) {
            const RelayDemand demand{controls[i] == '#', i < unlatch.size() && unlatch[i] == '#', override_state};
            seen += relay.advance(drive, demand, polarity, times, now) ? '#' : '.';
            EXPECT_TRUE(relay.is_consistent()) << "after " << i + 1 << " ms";
            now = now + milliseconds(1);
        }
        return seen;
    }

    Relay relay;
    RelayTimes times{Duration{}, Duration{}, milliseconds(2)};
    Instant now{};
};

}  // namespace

TEST_F(RelayTest, RelayFollowsNormalAndInversePolarityAndIsOffWithPolarity0) {
    verifies<req::AOR_RELAY_002>();
    EXPECT_EQ(run(".##.", not_implemented), "....");
    EXPECT_EQ(run(".##.", normal), ".##.");
    EXPECT_EQ(run(".##.", inverse), "#..#");
}

TEST_F(RelayTest, LatchedRelayChangesWhenTheControlGoesOn) {
    verifies<req::AOR_RELAY_003>();
    EXPECT_EQ(run("..##..#.#.", latched), "..####..##");
}

TEST_F(RelayTest, InverseLatchedRelayRestsOnAndChangesWhenTheControlGoesOff) {
    verifies<req::AOR_RELAY_004>();
    EXPECT_EQ(run("..##..#.##.#", inverse_latched), "####...###..");
}

TEST_F(RelayTest, RelayWithTogglePolarityStartsWithOnAndTogglesWhileItsControlIsOn) {
    verifies<req::AOR_RELAY_008, req::AOR_RELAY_026>();
    EXPECT_EQ(run(".#######..##", toggle), ".##..##...##");
    times.blink = milliseconds(0);
    EXPECT_EQ(run(".####", toggle), ".####");
}

TEST_F(RelayTest, TogglingStartsWithOnAlsoForARelayThatIsOn) {
    verifies<req::AOR_RELAY_008>();
    EXPECT_EQ(run("###", normal), "###");
    EXPECT_EQ(run("####", toggle), "##..");
}

TEST_F(RelayTest, UnlatchPutsALatchedRelayOff) {
    verifies<req::AOR_RELAY_005>();
    //                     control       unlatch
    EXPECT_EQ(run("#......", latched, "...##.."), "###....");
}

TEST_F(RelayTest, ControlMustGoOffAfterUnlatchingBeforeItLatchesAgain) {
    verifies<req::AOR_RELAY_020>();
    // The control is ON from 0 ms on. Unlatched from 2 to 3 ms, the relay goes OFF and stays OFF. The control is OFF at
    // 6 ms and ON at 7 ms: the relay latches again.
    EXPECT_EQ(run("######.##", latched, "..##....."), "##.....##");
}

TEST_F(RelayTest, ControlEdgesDuringUnlatchingAreIgnored) {
    verifies<req::AOR_RELAY_005, req::AOR_RELAY_020>();
    // The control goes ON at 3 ms, while the relay is unlatched, and stays ON: the relay stays OFF. It goes ON only at
    // 7 ms, after the control was OFF at 6 ms.
    EXPECT_EQ(run("...###.#", latched, "..##...."), ".......#");
}

TEST_F(RelayTest, ControlEdgeAtTheEndOfUnlatchingIsIgnored) {
    verifies<req::AOR_RELAY_020>();
    EXPECT_EQ(run("..##.#", latched, "##...."), ".....#");
}

TEST_F(RelayTest, ControlThatIsOffAtTheEndOfUnlatchingLatchesAtItsNextEdge) {
    verifies<req::AOR_RELAY_020>();
    EXPECT_EQ(run("#...#", latched, ".##.."), "#...#");
}

TEST_F(RelayTest, UnlatchPutsAnInverseLatchedRelayOn) {
    verifies<req::AOR_RELAY_006, req::AOR_RELAY_021>();
    // The control goes OFF at 1 ms, and the relay goes OFF. Unlatched at 3 ms, the relay goes ON. It stays ON until 7
    // ms, when the control goes OFF after it was ON at 6 ms.
    EXPECT_EQ(run("#.....#..", inverse_latched, "...##...."), "#..####..");
}

TEST_F(RelayTest, InverseLatchedRelayMirrorsTheLatchedRelayInEverySixStepSequence) {
    verifies<req::AOR_RELAY_003, req::AOR_RELAY_005, req::AOR_RELAY_006, req::AOR_RELAY_020, req::AOR_RELAY_021>();
    const auto mirrored = [](std::string row) {
        for (char& one : row) {
            one = one == '#' ? '.' : '#';
        }
        return row;
    };
    constexpr unsigned steps = 6;
    for (unsigned choice = 0; choice < 1U << 2U * steps; ++choice) {
        std::string controls = ".";  // in the first step, control and unlatch are OFF
        std::string unlatch = ".";
        for (unsigned step = 0; step < steps; ++step) {
            controls += (choice >> step & 1U) != 0 ? '#' : '.';
            unlatch += (choice >> (steps + step) & 1U) != 0 ? '#' : '.';
        }
        relay = Relay{};
        const std::string latch = run(controls, latched, unlatch);
        relay = Relay{};
        ASSERT_EQ(run(mirrored(controls), inverse_latched, unlatch), mirrored(latch)) << controls << " " << unlatch;
    }
}

TEST_F(RelayTest, RelayAcceptsTheFirstEdgeAfterItsLatchPolarityIsSelectedAgain) {
    verifies<req::AOR_RELAY_020, req::AOR_RELAY_021, req::AOR_RELAY_003>();
    // The relay is unlatched when a polarity without a latch is selected. When a latch is selected again, it accepts
    // the first edge of the control.
    EXPECT_EQ(run("#.", latched, ".#"), "#.");
    EXPECT_EQ(run(".", normal), ".");
    EXPECT_EQ(run("#", latched), "#");
    EXPECT_EQ(run("#", inverse_latched), "#") << "the inverse latch rests ON";
    EXPECT_EQ(run(".", inverse_latched), ".");
    EXPECT_EQ(run(".", latched), ".") << "and the latch OFF";
}

TEST_F(RelayTest, RelayIgnoresEdgesWhileUnlatchedAfterALatchPolarityIsSet) {
    verifies<req::AOR_RELAY_005, req::AOR_RELAY_006>();
    EXPECT_EQ(run(".", normal, "#"), ".");
    EXPECT_EQ(run("#.#", latched, "###"), "...");
    EXPECT_EQ(run(".#.", inverse_latched, "###"), "###");
}

TEST_F(RelayTest, UnlatchInputHasNoEffectOnARelayWithoutALatch) {
    verifies<req::AOR_RELAY_007>();
    EXPECT_EQ(run(".##.", normal, "####"), ".##.");
    EXPECT_EQ(run(".##.", inverse, "####"), "#..#");
    EXPECT_EQ(run("##", toggle, "##"), "##");
    EXPECT_EQ(run(".#..#.#", never_unlatched, ".#####."), ".###..#") << "nor with a latch that has none";
}

TEST_F(RelayTest, LatchIsKeptAndControlEdgesAreIgnoredWhileTheControlIsOverruled) {
    verifies<req::AOR_RELAY_017, req::AOR_RELAY_025>();
    EXPECT_EQ(run(".#.", latched), ".##");
    for (const auto drive : {OutputDrive::override_value, OutputDrive::shut_off, OutputDrive::fault_value}) {
        EXPECT_EQ(run("..##", latched, "", drive), "....") << "overridden with OFF, disabled, in error";
        EXPECT_EQ(run("#.", latched), "##") << "one edge passed by, the control is still ON";
    }
    EXPECT_EQ(run("..##", latched, "", OutputDrive::keep), "####") << "disabled, kept";
    EXPECT_EQ(run("#.", latched), "##") << "an edge passed by";
    EXPECT_EQ(run("#.", latched), "..");
    EXPECT_EQ(run("#.#", inverse_latched), "#..");
    EXPECT_EQ(run("#.", inverse_latched, "", OutputDrive::shut_off), "..");
    EXPECT_EQ(run(".#.", inverse_latched), "..#");
}

TEST_F(RelayTest, ShutOffResponsePutsARelayOfAnyPolarityOffAndKeepResponseFreezesIt) {
    verifies<req::AOR_RELAY_009, req::AOR_RELAY_027>();
    for (const RelayPolarity& polarity :
         {not_implemented, normal, inverse, latched, never_unlatched, inverse_latched, toggle}) {
        EXPECT_EQ(run("#", normal), "#");
        EXPECT_EQ(run("..##", polarity, "", OutputDrive::shut_off), "....");
    }
    EXPECT_EQ(run("..", inverse), "##");
    EXPECT_EQ(run("##", inverse, "", OutputDrive::keep), "##");
}

TEST_F(RelayTest, OverrideSetsTheStateOfTheRelay) {
    verifies<req::AOR_RELAY_010>();
    EXPECT_EQ(run("..", normal, "", OutputDrive::override_value, true), "##");
    EXPECT_EQ(run("##", normal, "", OutputDrive::override_value, false), "..");
}

TEST_F(RelayTest, ErrorAndShutdownPutTheRelayOff) {
    verifies<req::AOR_RELAY_011>();
    EXPECT_EQ(run("#", normal), "#");
    EXPECT_EQ(run("#", normal, "", OutputDrive::fault_value), ".");
    EXPECT_EQ(run("#", normal), "#");
    EXPECT_EQ(run("#", inverse, "", OutputDrive::shutdown), ".");
}

TEST_F(RelayTest, DelaysApplyToSwitchingOnAndOff) {
    verifies<req::AOR_RELAY_012>();
    times = {milliseconds(3), milliseconds(2), milliseconds(2)};
    EXPECT_EQ(run(".#####.....", normal), "....####...");
}

TEST_F(RelayTest, DelayOfADayIsExact) {
    verifies<req::AOR_RELAY_012>();
    times = {milliseconds(86'400'000), milliseconds(86'400'000), milliseconds(2)};
    now = Instant{} + milliseconds(5);
    EXPECT_EQ(run("#", normal), ".");
    now = Instant{} + milliseconds(86'400'004);
    EXPECT_EQ(run("##", normal), ".#");
}

TEST_F(RelayTest, CommandThatEndsDuringItsDelayIsDropped) {
    verifies<req::AOR_RELAY_013, req::AOR_RELAY_022>();
    times = {milliseconds(3), milliseconds(3), milliseconds(2)};
    EXPECT_EQ(run("##.##.###.", normal), "..........");
    EXPECT_EQ(run("####", normal), "...#") << "and the next runs its whole delay";
    EXPECT_EQ(run("..#..####", normal), "#########");
}

TEST_F(RelayTest, DelaysApplyToEnablingAndDisabling) {
    verifies<req::AOR_RELAY_012>();
    times = {milliseconds(2), milliseconds(2), milliseconds(2)};
    EXPECT_EQ(run("####", normal), "..##");
    EXPECT_EQ(run("####", normal, "", OutputDrive::shut_off), "##..");
    EXPECT_EQ(run("####", normal), "..##");
}

TEST_F(RelayTest, OverrideAndFaultAreNotDelayed) {
    verifies<req::AOR_RELAY_014, req::AOR_RELAY_023>();
    times = {milliseconds(2), milliseconds(2), milliseconds(2)};
    EXPECT_EQ(run("..", normal, "", OutputDrive::override_value, true), "##");
    EXPECT_EQ(run("...", normal), "##.") << "the way back is delayed";
    EXPECT_EQ(run("###", normal), "..#");
    EXPECT_EQ(run("#", normal, "", OutputDrive::fault_value), ".");
    EXPECT_EQ(run("###", normal), "..#");
}

TEST_F(RelayTest, DelaysShiftTheWholeTogglePatternOfTheRelay) {
    verifies<req::AOR_RELAY_015>();
    times = {milliseconds(4), milliseconds(4), milliseconds(1)};
    // The control is ON from 0 to 8 ms; with delays of 4 ms the relay toggles from 4 to 12 ms.
    EXPECT_EQ(run("########......", toggle), "....#.#.#.#...");
}

TEST_F(RelayTest, TimeOfTheNextRelayChangeIsReported) {
    verifies<req::AOR_RELAY_012>();
    EXPECT_EQ(relay.next_change(), never);
    times.on_delay = milliseconds(5);
    run("#", normal);
    EXPECT_EQ(relay.next_change().us, 5000U);
    run("######", normal);  // the last call is at 6 ms: the relay has changed at 5 ms
    EXPECT_EQ(relay.next_change(), never);
    times.on_delay = Duration{};
    run(".", normal);
    run("#", toggle);  // the relay goes ON at 8 ms; it toggles every 2 ms
    EXPECT_EQ(relay.next_change().us, 10000U);
    run("#", normal, "", OutputDrive::override_value);
    EXPECT_EQ(relay.next_change(), never);
}

TEST_F(RelayTest, RampOffResponsePutsTheRelayOffAfterItsOffDelay) {
    verifies<req::AOR_RELAY_012>();
    // A relay has no ramp: the drive `ramp_off` of an output switches the relay off after its OFF delay.
    times.off_delay = milliseconds(2);
    EXPECT_EQ(run("##", normal), "##");
    EXPECT_EQ(run("####", normal, "", OutputDrive::ramp_off), "##..");
}

}  // namespace canproof::test
