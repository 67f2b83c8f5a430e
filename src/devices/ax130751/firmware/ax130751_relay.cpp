// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751_relay.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

static_assert(implements<req::AOR_T10>);
SwitchDrive switch_drive(const std::uint8_t value, const bool before, const bool control) noexcept {
    namespace table = own::relay_polarity;
    return cell_or(table::find(value, before, control), &table::Row::drive, SwitchDrive::off);
}

/// Returns whether `value` in 2242h relay polarity implements the relay. With 0 or an unknown value the relay is not
/// implemented and stays OFF.
bool is_implemented(const std::uint8_t value) noexcept {
    namespace table = own::relay_polarity;
    return cell_or(table::find(value, false, false), &table::Row::drive, SwitchDrive::none) != SwitchDrive::none;
}

UnlatchEffect unlatch_effect(const std::uint8_t value) noexcept {
    namespace table = own::relay_polarity;
    return cell_or(table::find(value, false, false), &table::Row::unlatch, UnlatchEffect::ignored);
}

static_assert(implements<req::AOR_T11> && implements<req::AOR_E_OUTPUT_DRIVE>);
OutputDrive enable_drive(const std::uint8_t response, const bool on) noexcept {
    namespace table = own::relay_enable_response;
    return cell_or(table::find(response, on), &table::Row::drive, OutputDrive::shut_off);
}

static_assert(implements<req::AOR_T12>);
bool is_overridden(const std::uint8_t response, const bool on) noexcept {
    return cell_or(own::relay_override_response::find(response, on), &own::relay_override_response::Row::overridden,
                   false);
}

static_assert(implements<req::AOR_T11B>);
bool override_state(const std::uint8_t value) noexcept {
    return cell_or(own::relay_override_state::find(value), &own::relay_override_state::Row::on, false);
}

}  // namespace

void RelayOutput::reset(const bool powered, Outputs& outputs) noexcept {
    relay_.reset();
    control_ = DigitalReading{};
    unlatch_ = DigitalReading{};
    enable_ = DigitalReading{};
    override_ = DigitalReading{};
    show(false, powered, outputs);
}

static_assert(implements<req::AOR_RELAY_016> && implements<req::AOR_RELAY_024> && implements<req::AOR_RELAY_018>);
void RelayOutput::advance(const OutputCycle& cycle, Outputs& outputs) noexcept {
    const RelayPolarity wanted = polarity();
    const bool absent = !is_implemented(objects_.get(field::o2242_relay_polarity[1U]));
    const BlockSignal control = sources_.signal(control_choice_.follow(
        objects_.get(field::o2260_relay_control_source[1U]), objects_.get(field::o2261_relay_control_number[1U])));
    static_cast<void>(control_.read(control));
    const OutputDrive drive = drive_of(control, wanted, cycle.shutdown || absent);
    const RelayDemand demand{control_.on(), unlatch_.on(),
                             override_state(objects_.get(field::o2293_relay_override_state[1U])), control.is_valid()};
    show(relay_.advance(drive, demand, wanted, times(), cycle.now), cycle.powered, outputs);
}

OutputDrive RelayOutput::drive_of(const BlockSignal& control, const RelayPolarity& polarity,
                                  const bool shutdown) noexcept {
    const BlockSignal unlatch = sources_.signal(unlatch_choice_.follow(
        objects_.get(field::o2270_relay_unlatch_source[1U]), objects_.get(field::o2271_relay_unlatch_number[1U])));
    const BlockSignal enable = sources_.signal(enable_choice_.follow(
        objects_.get(field::o2280_relay_enable_source[1U]), objects_.get(field::o2281_relay_enable_number[1U])));
    const BlockSignal forced = sources_.signal(override_choice_.follow(
        objects_.get(field::o2290_relay_override_source[1U]), objects_.get(field::o2291_relay_override_number[1U])));
    static_cast<void>(unlatch_.read(unlatch));
    const bool enabled = enable_.read(enable);
    const bool override_on = override_.read(forced);
    OutputConditions conditions{};
    const bool unlatches = polarity.unlatch != UnlatchEffect::ignored;
    const bool in_error =
        control.is_in_error() || enable.is_in_error() || forced.is_in_error() || (unlatch.is_in_error() && unlatches);
    static_assert(implements<req::AOR_RELAY_028>);
    conditions.shutdown = shutdown || in_error || sources_.lacks(enable_choice_, enable) ||
                          sources_.lacks(override_choice_, forced) ||
                          (sources_.lacks(unlatch_choice_, unlatch) && unlatches);
    conditions.overridden =
        forced.is_available() && is_overridden(objects_.get(field::o2292_relay_override_response[1U]), override_on);
    conditions.enable = enable.is_available()
                            ? enable_drive(objects_.get(field::o2282_relay_enable_response[1U]), enabled)
                            : OutputDrive::control;
    if ((!control.is_available()) && (conditions.enable == OutputDrive::control)) {
        conditions.enable = OutputDrive::shut_off;  // without a control signal the relay is OFF, whatever the polarity
    }
    return choose_drive(conditions);
}

RelayPolarity RelayOutput::polarity() const noexcept {
    const std::uint8_t value = objects_.get(field::o2242_relay_polarity[1U]);
    RelayPolarity made{};
    made.answer.was_off = {{switch_drive(value, false, false), switch_drive(value, false, true)}};
    made.answer.was_on = {{switch_drive(value, true, false), switch_drive(value, true, true)}};
    made.unlatch = unlatch_effect(value);
    return made;
}

RelayTimes RelayOutput::times() const noexcept {
    const bool delayed = objects_.get(field::o22a0_relay_enable_response_delay[1U]) != 0U;
    const Duration blink = milliseconds(objects_.get(field::o2250_relay_blink_rate[1U]));
    if (!delayed) {
        return RelayTimes{Duration{}, Duration{}, blink};
    }
    return RelayTimes{milliseconds(objects_.get(field::o22a1_relay_on_delay[1U])),
                      milliseconds(objects_.get(field::o22a2_relay_off_delay[1U])), blink};
}

/// Sets the contacts for a state. The coil carries current only in state OFF, so without a supply the contacts are
/// those of state ON.
static_assert(implements<req::AOR_RELAY_001> && implements<req::AOR_RELAY_019> && implements<req::AOR_T_CONTACT>);
void RelayOutput::show(const bool on, const bool powered, Outputs& outputs) noexcept {
    const auto* const row = own::relay_contact::find(on || (!powered));
    outputs.relay_nc = cell_or(row, &own::relay_contact::Row::normally_closed, false);
    outputs.relay_no = cell_or(row, &own::relay_contact::Row::normally_open, false);
}

}  // namespace canproof::ax130751
