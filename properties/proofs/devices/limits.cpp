// SPDX-License-Identifier: Apache-2.0
// Theorems on the faults that a device reports when a measured value exceeds a limit, for any value, also NaN.
#include "devices/ax130751/firmware/analogue_output.hpp"
#include "devices/ax130751/firmware/digital_reading.hpp"
#include "devices/ax130751/firmware/limit_fault.hpp"
#include "devices/ax188001/firmware/limit_condition.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/ax188001/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

using ax130751::BlockSignal;
using ax130751::SignalState;
using ax188001::DelayedFault;
using ax188001::FaultCondition;

}  // namespace

void a_limit_fault_lasts_until_it_recovers() {
    shows(
        "a fault with hysteresis is present exactly when its value is beyond the limit, or was and has not recovered");
    proves<req::AOR_DIAG_005>();
    ax130751::LimitFault fault{};
    leave_open(fault);
    const bool before = fault.is_present();
    const bool enabled = any<bool>();
    const bool beyond = any<bool>();
    const bool recovered = any<bool>();
    claim(fault.advance(enabled, beyond, recovered) == (enabled && (beyond || (before && !recovered))));
    claim(fault.is_present() == (enabled && (beyond || (before && !recovered))));
}

void a_limit_never_begins_and_ends_a_fault() {
    shows("a value never begins and ends the same limit fault; NaN begins a fault of an upper limit and no other");
    proves<req::TCS_FD_002, req::TCS_FD_003, req::TCS_FD_008>();
    const auto value = any<double>();
    const auto set = any<double>();
    const auto clear = any<double>();
    const FaultCondition high = ax188001::high_limit(value, set, clear);
    const FaultCondition low = ax188001::low_limit(value, set, clear);
    claim(!(set >= clear) || !(high.begins && high.ends));
    claim(!(set <= clear) || !(low.begins && low.ends));
    claim((value <= value) || (high.begins && !(high.ends || low.begins || low.ends)));
}

void a_delayed_fault_is_told_after_its_delay() {
    shows(
        "a fault is reported exactly when it has lasted for its delay, for any times of 64 bits; its end clears it at "
        "once");
    proves<req::TCS_LIM_012>();
    DelayedFault fault{};
    leave_open(fault);
    const bool was_told = fault.told();
    const Instant since = fault.since_;
    assume(!was_told || (since == never));
    const auto condition = any<FaultCondition>();
    const Duration delay{any<std::uint64_t>()};
    const Instant now = any<Instant>();
    fault.judge(condition, delay, now);
    const bool is_over = (earliest(since, now) + delay) <= now;
    claim(fault.told() == (was_told ? !condition.ends : (condition.begins && is_over)));
    claim(!fault.told() || (fault.since_ == never));
    claim(was_told || condition.begins || (fault.since_ == never));
}

void a_signal_is_read_with_hysteresis() {
    shows(
        "a valid signal is OFF at or below its lower limit and ON at or above its upper one; one in error keeps the "
        "state; one that is not available is OFF");
    proves<req::AOR_SRC_001>();
    ax130751::DigitalReading reading{};
    leave_open(reading);
    const bool before = reading.on();
    const BlockSignal signal{any<double>(), any<double>(), any<double>(), static_cast<SignalState>(each(3U))};
    const bool after = reading.read(signal);
    const bool is_low = signal.value <= signal.lower;
    const bool is_high = signal.value >= signal.upper;
    claim((signal.state != SignalState::not_available) || !after);
    claim((signal.state != SignalState::error) || (after == before));
    claim((signal.state != SignalState::valid) || (after == (!is_low && (is_high || before))));
}

void an_output_value_is_within_its_range() {
    shows("the nearest value in a range is 0 or within the range, is the value itself there, and is monotone");
    proves<req::AOR_OUT_016, req::AOR_OUT_034>();
    const ax130751::OutputRange range{any<double>(), any<double>()};
    const auto a = any<double>();
    const auto b = any<double>();
    assume((range.minimum <= range.maximum) && (a <= b));
    const double low = range.nearest(a);
    const double high = range.nearest(b);
    claim((low <= range.maximum) && ((low >= range.minimum) || (low == 0.0)));
    claim(low <= high);
    claim(!((a >= range.minimum) && (a <= range.maximum)) || (low == a));
    claim(range.nearest(low) == low);
}

void a_value_that_is_no_number_puts_an_output_off() {
    shows("the nearest value of NaN is 0 in any range");
    proves<req::AOR_OUT_016>();
    const ax130751::OutputRange range{any<double>(), any<double>()};
    const auto value = any<double>();
    assume(!(value <= value));
    claim(range.nearest(value) == 0.0);
}

}  // namespace canproof::proofs
