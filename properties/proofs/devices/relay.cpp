// SPDX-License-Identifier: Apache-2.0
// Theorems on the relay of the AX130751: from any state and with any inputs the relay switches ON only when an input
// demands it, and a shutdown switches it OFF at once.
#include "devices/ax130751/firmware/relay.hpp"

#include "generated/ax130751/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

using ax130751::OutputDrive;
using ax130751::Relay;
using ax130751::SwitchDrive;

/// A relay in any state, with any inputs.
struct AnyRelay {
    Relay relay{};
    OutputDrive drive{any<OutputDrive>()};
    ax130751::RelayDemand demand{any<ax130751::RelayDemand>()};
    ax130751::RelayPolarity polarity{any<ax130751::RelayPolarity>()};
    ax130751::RelayTimes times{any<ax130751::RelayTimes>()};
    Instant now{any<Instant>()};

    AnyRelay() {
        leave_open(relay);
        assume(relay.is_consistent());
    }
    /// Returns the previous state of the control input. After a call without a valid control input, the present state
    /// takes its place.
    bool control_before() const { return relay.was_valid_ ? relay.control_before_ : demand.control; }
    bool advance() { return relay.advance(drive, demand, polarity, times, now); }
    /// Returns what the polarity requires for the previous and the present state of the control input.
    SwitchDrive answer(const bool control_before) const {
        return polarity.answer.drive(control_before, demand.control);
    }
};

bool is_of_latch(const SwitchDrive answer) {
    return (answer == SwitchDrive::keep) || (answer == SwitchDrive::change);
}

}  // namespace

void a_relay_switches_on_only_when_it_is_demanded() {
    shows(
        "a relay that is OFF goes ON only if its control drives it and demands ON by polarity or latch, or an override "
        "with the state ON drives it");
    proves<req::AOR_RELAY_009, req::AOR_RELAY_010, req::AOR_RELAY_011>();
    AnyRelay any_relay{};
    const bool was_on = any_relay.relay.delayed_.state_;
    const SwitchDrive answer = any_relay.answer(any_relay.control_before());
    const bool is_on = any_relay.advance();
    const bool demands = (answer == SwitchDrive::on) || (answer == SwitchDrive::blink) ||
                         (is_of_latch(answer) && any_relay.relay.memory_);
    const bool by_control = (any_relay.drive == OutputDrive::control) && demands;
    const bool by_override = (any_relay.drive == OutputDrive::override_value) && any_relay.demand.override_state;
    claim(!is_on || was_on || by_control || by_override);
    claim(any_relay.relay.is_consistent());
}

void a_plain_relay_follows_its_control() {
    shows("without delays a relay of the polarity normal (Table 10, value 1) is ON exactly while its control is ON");
    proves<req::AOR_RELAY_002>();
    AnyRelay any_relay{};
    any_relay.polarity = ax130751::RelayPolarity{};
    any_relay.drive = OutputDrive::control;
    any_relay.times.on_delay = Duration{};
    any_relay.times.off_delay = Duration{};
    any_relay.relay.blinking_ = false;
    any_relay.relay.state_ = any_relay.relay.delayed_.state_;
    const bool is_pending = any_relay.relay.delayed_.pending_;
    assume(!is_pending || (any_relay.relay.delayed_.since_ <= any_relay.now));
    claim(any_relay.advance() == any_relay.demand.control);
}

void a_latch_changes_only_by_its_inputs() {
    shows(
        "the latch of a relay changes only by a change of the control that drives the relay, by the unlatch input, or "
        "by a new effect of the unlatch input");
    proves<req::AOR_RELAY_017, req::AOR_RELAY_025, req::AOR_RELAY_005, req::AOR_RELAY_006>();
    AnyRelay any_relay{};
    const bool before = any_relay.relay.memory_;
    const bool is_new_effect = any_relay.relay.effect_ != any_relay.polarity.unlatch;
    const bool is_unlatched =
        any_relay.demand.unlatch && (any_relay.polarity.unlatch != ax130751::UnlatchEffect::ignored);
    const SwitchDrive answer = any_relay.answer(any_relay.control_before());
    static_cast<void>(any_relay.advance());
    const bool changes = (any_relay.drive == OutputDrive::control) && (answer == SwitchDrive::change);
    claim((any_relay.relay.memory_ == before) || is_new_effect || is_unlatched || changes);
    const bool is_rest_on = any_relay.polarity.unlatch == ax130751::UnlatchEffect::to_on;
    claim(!is_unlatched || (any_relay.relay.memory_ == is_rest_on));
}

void a_shutdown_opens_a_relay_at_once() {
    shows("a shutdown or an input in error puts the relay OFF at once, whatever its state, polarity and delays are");
    proves<req::AOR_RELAY_011, req::AOR_RELAY_014, req::AOR_RELAY_018>();
    AnyRelay any_relay{};
    any_relay.drive = (each(2U) == 0U) ? OutputDrive::shutdown : OutputDrive::fault_value;
    claim(!any_relay.advance());
    claim(any_relay.relay.next_change() == never);
    claim(any_relay.relay.is_consistent());
}

void an_override_decides_a_relay_at_once() {
    shows("an override gives the relay its own state at once, and keep leaves the present state");
    proves<req::AOR_RELAY_010, req::AOR_RELAY_014>();
    AnyRelay any_relay{};
    const bool keeps = each(2U) == 1U;
    any_relay.drive = keeps ? OutputDrive::keep : OutputDrive::override_value;
    const bool before = any_relay.relay.state_;
    claim(any_relay.advance() == (keeps ? before : any_relay.demand.override_state));
    claim(any_relay.relay.is_consistent());
}

void a_disabled_relay_opens_within_its_delay() {
    shows(
        "a relay that is shut off is OFF as soon as the OFF delay is over since the request, at once without a delay");
    proves<req::AOR_RELAY_009, req::AOR_RELAY_012>();
    AnyRelay any_relay{};
    any_relay.drive = OutputDrive::shut_off;
    const bool was_pending = any_relay.relay.delayed_.pending_;
    const Instant since = was_pending ? any_relay.relay.delayed_.since_ : any_relay.now;
    const bool is_on = any_relay.advance();
    claim(!is_on || (any_relay.now < (since + any_relay.times.off_delay)));
    claim(any_relay.relay.is_consistent());
}

void a_delayed_state_changes_after_its_whole_delay() {
    shows(
        "a state with delays changes exactly when the wanted state has lasted for its delay, for any times of 64 bits, "
        "and a request that returns before cancels the change");
    proves<req::AOR_RELAY_012, req::AOR_RELAY_013, req::AOR_RELAY_022>();
    ax130751::DelayedState delayed{};
    leave_open(delayed);
    const bool before = delayed.state_;
    const bool was_pending = delayed.pending_;
    const bool wanted = any<bool>();
    const Duration on_delay{any<std::uint64_t>()};
    const Duration off_delay{any<std::uint64_t>()};
    const Instant now = any<Instant>();
    const Instant since = was_pending ? delayed.since_ : now;
    const bool after = delayed.follow(wanted, on_delay, off_delay, now);
    const bool is_over = (since + (wanted ? on_delay : off_delay)) <= now;
    claim(after == (((wanted == before) || !is_over) ? before : wanted));
    claim(delayed.pending_ == (wanted != after));
    claim((wanted == after) ? (delayed.due() == never) : (delayed.since_ == since));
}

}  // namespace canproof::proofs
