// SPDX-License-Identifier: Apache-2.0
// Properties of the output blocks of the AX130751 (manual, 1.2 to 1.4 and 1.8).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>

#include "devices/ax130751/firmware/analogue_output.hpp"
#include "devices/ax130751/firmware/blinking.hpp"
#include "devices/ax130751/firmware/delayed_state.hpp"
#include "devices/ax130751/firmware/digital_reading.hpp"
#include "devices/ax130751/firmware/limit_fault.hpp"
#include "devices/ax130751/firmware/linear_scaling.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

/// Returns a multiple of 0.01 from `low` to `high`. With such numbers, results do not depend on the last bit of a
/// double.
double hundredths(int low, int high) {
    return *rc::gen::inRange(low * 100, (high * 100) + 1) / 100.0;
}

Duration some_ms(std::uint64_t low, std::uint64_t end) {
    return milliseconds(*rc::gen::inRange<std::uint64_t>(low, end));
}

RampTimes some_times() {
    return {hundredths(0, 20), some_ms(0, 10001), some_ms(0, 10001)};
}

/// The output ranges of Table 3.
const std::vector<OutputRange> ranges{{-10.0, 10.0}, {0.0, 24.0}, {0.0, 100.0}, {50.0, 30000.0}};

}  // namespace

RC_GTEST_PROP(OutputLaw, ScaledValueStaysBetweenTheFieldValuesOfItsScaling, ()) {
    verifies<req::AOR_OUT_003>("property");
    const double x1 = hundredths(-300, 299);
    const LinearScaling scaling{x1, x1 + hundredths(1, 100), hundredths(-300, 300), hundredths(-300, 300)};
    const double y = scale(hundredths(-600, 600), scaling);
    RC_ASSERT(y >= std::fmin(scaling.y1, scaling.y2) - 1e-9);
    RC_ASSERT(y <= std::fmax(scaling.y1, scaling.y2) + 1e-9);
}

RC_GTEST_PROP(OutputLaw, OutputsStayInTheRangeOfTheirType, ()) {
    verifies<req::AOR_OUT_016, req::AOR_OUT_034>("property");
    const OutputRange range = *rc::gen::elementOf(ranges);
    AnalogueOutput output;
    Instant now{};
    const int steps = *rc::gen::inRange(1, 30);
    for (int step = 0; step < steps; ++step) {
        const auto drive = static_cast<OutputDrive>(*rc::gen::inRange(0, 7));
        const AnalogueDemand demand{hundredths(-40000, 40000), hundredths(-40000, 40000), hundredths(-40000, 40000)};
        now = now + some_ms(0, 3000);
        const auto state = output.advance(drive, demand, range, some_times(), now);
        for (const double value : {state.value, state.target}) {
            const bool off = value >= 0.0 && value <= 0.0;
            RC_ASSERT(off || (value >= range.minimum && value <= range.maximum));
        }
    }
}

RC_GTEST_PROP(OutputLaw, RampIsNeverSteeperThanConfiguredAndReachesItsTarget, ()) {
    verifies<req::AOR_OUT_012, req::AOR_OUT_013>("property");
    const RampTimes times{hundredths(1, 20), some_ms(1, 10001), some_ms(1, 10001)};
    Ramp ramp;
    ramp.set(hundredths(-10, 10));
    Instant now{};
    double before = ramp.value_at(now);
    for (int turn = 0; turn < 5; ++turn) {
        const double target = hundredths(-10, 10);
        ramp.follow(target, times, now);
        const int steps = *rc::gen::inRange(1, 10);
        for (int step = 0; step < steps; ++step) {
            const auto ms = static_cast<std::uint64_t>(*rc::gen::inRange(0, 2000));
            now = now + milliseconds(ms);
            const double value = ramp.follow(target, times, now);
            const double length_ms = static_cast<double>((value > before ? times.up : times.down).us) / 1000.0;
            RC_ASSERT(std::fabs(value - before) <= (times.span * static_cast<double>(ms) / length_ms) + 1e-9);
            before = value;
        }
    }
    const double last = hundredths(-10, 10);
    ramp.follow(last, times, now);
    // A ramp crosses at most 20 units and needs at most 10 s for each unit, so it ends within 200 s.
    RC_ASSERT(std::fabs(ramp.follow(last, times, now + milliseconds(200'001)) - last) <= 0.0);
}

RC_GTEST_PROP(OutputLaw, RampDoesNotDependOnHowOftenItIsRead, ()) {
    verifies<req::AOR_OUT_027>("property");
    const RampTimes times = some_times();
    Ramp often;
    Ramp seldom;
    Instant now{};
    for (int turn = 0; turn < 5; ++turn) {
        const double target = hundredths(-10, 10);
        often.follow(target, times, now);
        seldom.follow(target, times, now);
        const int steps = *rc::gen::inRange(0, 10);
        for (int step = 0; step < steps; ++step) {
            now = now + some_ms(0, 700);
            often.follow(target, times, now);
        }
        RC_ASSERT(std::fabs(often.value_at(now) - seldom.value_at(now)) <= 0.0);
    }
}

RC_GTEST_PROP(OutputLaw, DigitalReadingTurnsOnAtItsUpperLimitAndOffAtItsLowerLimit, ()) {
    verifies<req::AOR_DO_002>("property");
    DigitalReading input;
    const double lower = hundredths(-10, 9);
    const double upper = lower + hundredths(1, 10);
    for (int step = 0; step < 40; ++step) {
        const bool before = input.on();
        const double value = hundredths(-12, 22);
        const bool on = input.read({value, lower, upper, SignalState::valid});
        RC_ASSERT(on == (value >= upper || (before && value > lower)));
    }
}

RC_GTEST_PROP(OutputLaw, BlinkingOutputIsOnAndOffForEqualTimes, ()) {
    verifies<req::AOR_DO_010>("property");
    const auto half = static_cast<std::uint64_t>(*rc::gen::inRange(1, 60001));
    const auto at = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000));
    const Instant since{*rc::gen::inRange<std::uint64_t>(0, 1'000'000'000)};
    const bool now = blinks_on(since, milliseconds(half), since + milliseconds(at));
    RC_ASSERT(now == ((at / half) % 2 == 0));
    RC_ASSERT(now != blinks_on(since, milliseconds(half), since + milliseconds(at + half)));
}

RC_GTEST_PROP(OutputLaw, StateWithDelaysChangesExactlyAfterItsOnOrOffDelay, ()) {
    verifies<req::AOR_RELAY_012>("property");
    const Duration on_delay = some_ms(0, 50);
    const Duration off_delay = some_ms(0, 50);
    DelayedState state;
    bool is = false;
    Instant now{};
    std::uint64_t asked_for = 0;  // how long, in ms, the present command has differed from the state
    for (int step = 0; step < 200; ++step) {
        const bool wanted = *rc::gen::arbitrary<bool>();
        const int stay = *rc::gen::inRange(1, 60);
        asked_for = 0;
        for (int ms = 0; ms < stay; ++ms) {
            const bool before = is;
            is = state.follow(wanted, on_delay, off_delay, now);
            const std::uint64_t delay = (wanted ? on_delay : off_delay).us / 1000U;
            if (before != wanted) {
                RC_ASSERT((is == wanted) == (asked_for >= delay));
                ++asked_for;
            } else {
                RC_ASSERT(is == wanted);
            }
            now = now + milliseconds(1);
        }
        // Commands the present state, which cancels a pending change. So the next command begins a new delay, even if
        // it is equal to the last one.
        if (state.due() != never) {
            state.follow(is, on_delay, off_delay, now);
        }
    }
}

RC_GTEST_PROP(OutputLaw, SupplyFaultBeginsBeyondItsLimitAndEndsOneHysteresisInsideIt, ()) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_003, req::AOR_DIAG_015, req::AOR_DIAG_016>("property");
    const double under = hundredths(0, 20);
    const double over = under + hundredths(1, 16);
    const double hysteresis = hundredths(1, 30);
    LimitFault low;
    LimitFault high;
    for (int step = 0; step < 50; ++step) {
        const bool was_low = low.is_present();
        const bool was_high = high.is_present();
        const double volts = hundredths(0, 60);
        const bool is_low = low.advance(true, volts < under, volts >= under + hysteresis);
        const bool is_high = high.advance(true, volts > over, volts <= over - hysteresis);
        RC_ASSERT(is_low == (volts < under || (was_low && volts < under + hysteresis)));
        RC_ASSERT(is_high == (volts > over || (was_high && volts > over - hysteresis)));
    }
}

}  // namespace canproof::test
