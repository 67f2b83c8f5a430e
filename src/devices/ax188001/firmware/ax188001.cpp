// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/ax188001.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "firmware/canopen/nmt.hpp"
#include "generated/ax188001/constants.hpp"
#include "generated/ax188001/profile.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"
#include "generated/canopen/constants.hpp"

namespace canproof::ax188001 {

namespace {

namespace own = generated::ax188001;
namespace field = generated::ax188001::field;

const LssConfiguration shipped{own::shipped_node_id, own::shipped_bit_rate};

const Duration scan_period = milliseconds(own::update_period_ms);
// If advance() is called late, it performs at most this number of the missed readings, beginning with the earliest, and
// skips the others.
constexpr std::size_t most_late_scans = 8U;

constexpr ErrorId channel_error(const ChannelFault fault, const std::size_t channel) noexcept {
    const std::size_t offset = (static_cast<std::size_t>(fault) * channel_count) + channel;
    return error_after(own::error::open_circuit_1, offset);
}
static_assert((channel_error(ChannelFault::open, 1U) == own::error::open_circuit_2) &&
              (channel_error(ChannelFault::high, 0U) == own::error::high_warning_1) &&
              (channel_error(ChannelFault::high, 1U) == own::error::high_warning_2) &&
              (channel_error(ChannelFault::low, 0U) == own::error::low_warning_1) &&
              (channel_error(ChannelFault::low, 1U) == own::error::low_warning_2) &&
              (channel_error(ChannelFault::shutdown, 0U) == own::error::shutdown_1) &&
              (channel_error(ChannelFault::shutdown, 1U) == own::error::shutdown_2));

constexpr ErrorId unit_error(const UnitFault fault) noexcept {
    return error_after(own::error::fd1_cpu_temperature, static_cast<std::size_t>(fault));
}
static_assert((unit_error(UnitFault::over_voltage) == own::error::fd2_over_voltage) &&
              (unit_error(UnitFault::under_voltage) == own::error::fd3_under_voltage));

static_assert(implements<req::TCS_T_REACTION>);
/// Returns the sub-index of 1029h error behaviour for a class of errors. The node itself handles communication errors.
constexpr std::uint8_t reaction_to(const own::error_reaction::Errors errors) noexcept {
    return cell_or(own::error_reaction::find(errors), &own::error_reaction::Row::subindex, std::uint8_t{0U});
}

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, own::profile.limit_abort},
      queue_{queue},
      lss_store_{memory},
      node_{objects_, memory, queue, *this, own::error_table, own::profile, pdos_.memory()},
      scanner_{objects_},
      factory_{factory} {}

static_assert(implements<req::TCS_LSS_001> && implements<req::TCS_LSS_006> && implements<req::TCS_LSS_002>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    const LssConfiguration stored = lss_store_.load(shipped);
    bit_rate_ = stored.bit_rate;
    node_.power_on(stored, inputs.can_state, inputs.can_overrun, now);
    set_inputs(inputs, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    advance_when_due(now);
    const std::uint8_t addressed = frame.data[1];
    if (nmt_command(frame, addressed).has_value()) {
        static_assert(implements<req::TCS_START_007>);
        start_others_at_ = never;  // an NMT command, to whichever node, shows that there is a master
    }
    node_.receive(frame, now);
    advance_when_due(now);  // a reset may have planned a self-start that is due now
    show_outputs();
}

void Device::advance_when_due(const Instant now) noexcept {
    if (next_deadline() <= now) {
        advance(now);
    }
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    advance(now);  // a reading that is due uses the inputs before the change
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, inputs.can_overrun, now);
}

void Device::advance(const Instant now) noexcept {
    scan_when_due(now);
    if (scanner_.next_deadline() <= now) {
        scanner_.advance(now);
        tell_faults(now);
    }
    node_.advance(now);
    start_others_when_due(now);
    show_outputs();
}

Instant Device::next_deadline() const noexcept {
    const Instant scanning = earliest(next_scan_, scanner_.next_deadline());
    return earliest(earliest(scanning, node_.next_deadline()), start_others_at_);
}

static_assert(implements<req::TCS_IN_015> && implements<req::TCS_K_UPDATE_PERIOD>);
void Device::scan_when_due(const Instant now) noexcept {
    static_assert(implements<req::TCS_IN_024>);
    if (is_due(next_scan_, scan_period, now)) {
        next_scan_ = earliest(next_scan_, now);
    }
    for (std::size_t i = 0U; (i < most_late_scans) && (next_scan_ <= now); ++i) {
        const Instant due = next_scan_;
        // First reports each fault whose delay has ended, because this reading could end it. Every report moves the
        // next deadline, so there are at most as many rounds as faults.
        while (scanner_.next_deadline() < due) {
            scanner_.advance(scanner_.next_deadline());
            tell_faults(due);
        }
        scanner_.read(inputs_);
        scanner_.evaluate(due);
        tell_faults(due);
        next_scan_ = due + scan_period;
    }
    if (next_scan_ <= now) {
        next_scan_ = now + scan_period;
    }
}

static_assert(implements<req::TCS_LIM_004>);
void Device::tell_faults(const Instant now) noexcept {
    const std::uint32_t channel_reaction = reaction_to(own::error_reaction::Errors::tc_input);
    const std::uint32_t unit_reaction = reaction_to(own::error_reaction::Errors::fault_detection);
    if (node_.state() == NmtState::initialising) {
        return;  // booted() reports the faults instead
    }
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        for (std::size_t i = 0U; i < channel_fault_count; ++i) {
            const ChannelFault fault = static_cast<ChannelFault>(i);
            tell(channel_error(fault, channel), scanner_.told(channel, fault), channel_reaction, now);
        }
    }
    for (std::size_t i = 0U; i < unit_fault_count; ++i) {
        const UnitFault fault = static_cast<UnitFault>(i);
        tell(unit_error(fault), scanner_.told(fault), unit_reaction, now);
    }
}

static_assert(implements<req::TCS_ERR_010> && implements<req::TCS_T_BEHAVIOUR>);
void Device::tell(const ErrorId error, const bool present, const std::uint8_t reaction, const Instant now) noexcept {
    const bool begins = present && !node_.has_error(error);
    node_.set_error(error, present, now);
    if (begins) {
        node_.apply_error_behaviour(reaction, now);
    }
}

static_assert(implements<req::TCS_VAL_008> && implements<req::TCS_LIM_010> && implements<req::TCS_LIM_014>);
void Device::after_write(const EntryRef& entry, const Instant now) {
    const own::Written change = own::written(entry.index, entry.row->subindex);
    // The sub-index is the channel, counted from 1. `channel` has no meaning for a parameter that belongs to no
    // channel.
    const std::size_t channel = (std::uint32_t{change.subindex} == channel_count) ? 1U : 0U;
    scanner_.reevaluate(change.parameter, channel, now);
    tell_faults(now);
}

void Device::put_factory_values(const ParameterGroup group) {
    if (group == ParameterGroup::communication) {
        objects_.set_given(field::o1018_3_revision_number, factory_.revision);
        objects_.set_given(field::o1018_4_serial_number, factory_.serial_number);
    }
}

void Device::restart(const Instant now) {
    scanner_.restart(inputs_);
    scanner_.evaluate(now);
    next_scan_ = now + scan_period;
    start_mode_ = objects_.get(field::o5555_start_in_operational_mode);
}

/// Takes the value of 5555h start in operational mode as the stored one when a write to 1010h (store parameters) saves
/// the manufacturer parameters.
AbortCode Device::save(const ParameterGroups saved) {
    if (has_group(saved, ParameterGroup::manufacturer)) {
        static_assert(implements<req::TCS_START_001> && implements<req::TCS_START_002>);
        start_mode_ = objects_.get(field::o5555_start_in_operational_mode);
    }
    return AbortCode::none;
}

static_assert(implements<req::TCS_T3> && implements<req::TCS_START_001> && implements<req::TCS_START_002>);
void Device::booted(const Instant now) {
    start_others_at_ = never;
    const auto* const row = own::start_mode::find(start_mode_);
    if (cell_or(row, &own::start_mode::Row::start, false)) {
        static_assert(implements<req::TCS_START_003>);
        node_.start_at(now);
        if (cell_or(row, &own::start_mode::Row::others, false)) {
            start_others_at_ = now + milliseconds(objects_.get(field::o5556_start_in_operational_nmt_delay));
        }
    }
    tell_faults(now);
    obey_lasting_faults(now);
}

/// Applies 1029h error behaviour to faults that last beyond a reset of the communication, in the same way as when they
/// were first reported. 1029h has priority over the self-start.
static_assert(implements<req::TCS_START_005> && implements<req::TCS_ERR_023>);
void Device::obey_lasting_faults(const Instant now) noexcept {
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        for (std::size_t i = 0U; i < channel_fault_count; ++i) {
            if (scanner_.told(channel, static_cast<ChannelFault>(i))) {
                node_.apply_error_behaviour(reaction_to(own::error_reaction::Errors::tc_input), now);
            }
        }
    }
    for (std::size_t i = 0U; i < unit_fault_count; ++i) {
        if (scanner_.told(static_cast<UnitFault>(i))) {
            node_.apply_error_behaviour(reaction_to(own::error_reaction::Errors::fault_detection), now);
        }
    }
}

static_assert(implements<req::TCS_START_006> && implements<req::TCS_START_008>);
void Device::start_others_when_due(const Instant now) noexcept {
    const bool due = start_others_at_ <= now;
    if (due) {
        start_others_at_ = never;
    }
    static_assert(implements<req::TCS_START_009>);
    if (due && (node_.state() == NmtState::operational)) {
        Frame command = data_frame(generated::canopen::nmt_command_cob_id, 2U);  // node-ID 0: all nodes
        command.data[0] = static_cast<std::uint8_t>(NmtCommand::start);
        static_cast<void>(queue_.push(command));
    }
}

static_assert(implements<req::TCS_LSS_004>);
void Device::set_bit_rate(const std::uint32_t bit_rate, const Instant) {
    bit_rate_ = bit_rate;
}

LssError Device::store_configuration(const LssConfiguration& configuration) {
    return lss_store_.store(configuration);
}

static_assert(implements<req::TCS_S_ADC_FILTER> && implements<req::TCS_S_ADC_GAIN>);
void Device::show_outputs() noexcept {
    outputs_.adc_filter = objects_.get(field::o2020_adc_filter_frequency);
    for (std::size_t channel = 0U; channel < channel_count; ++channel) {
        outputs_.tc_gain[channel] = scanner_.gain(channel);
    }
}

}  // namespace canproof::ax188001
