// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/firmware/ax130751.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/profile.hpp"
#include "generated/ax130751/requirements.hpp"

namespace canproof::ax130751 {

namespace {

namespace own = generated::ax130751;

constexpr std::array<ErrorId, 4U> heartbeat_errors{
    {ErrorId::heartbeat_1, ErrorId::heartbeat_2, ErrorId::heartbeat_3, ErrorId::heartbeat_4}};

const Duration cycle_time = milliseconds(own::cycle_ms);

/// Returns `deadline` when it is later than `done`, otherwise never.
constexpr Instant if_later(const Instant deadline, const Instant done) noexcept {
    return (deadline > done) ? deadline : never;
}

}  // namespace

static_assert(implements<req::AOR_ID_001>);
Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData& factory) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, own::profile.limit_abort},
      lss_store_{memory},
      node_{objects_, memory, queue, *this, own::error_table, own::profile, pdos_.memory()},
      factory_{factory},
      sources_{objects_},
      universal_{{UniversalOutput{objects_, sources_, 1U}, UniversalOutput{objects_, sources_, 2U}}},
      relay_{objects_, sources_} {}

static_assert(implements<req::AOR_NODE_001> && implements<req::AOR_LSS_003>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    called_ = now;
    static_assert(implements<req::AOR_K_NODE_ID> && implements<req::AOR_K_BIT_RATE>);
    static_assert(implements<req::AOR_NODE_006>);
    kept_ = lss_store_.load(LssConfiguration{own::shipped_node_id, own::shipped_bit_rate});
    lss_stored_ = kept_;
    bit_rate_ = kept_.bit_rate;
    node_.power_on(kept_, inputs.can_state, inputs.can_overrun, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    advance(now);
    node_.receive(frame, now);
    watch_network(now);
    wake(now);
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    advance(now);
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, inputs.can_overrun, now);
    wake(now);
}

/// Runs the cycles and the deadlines of the node in the order of their times. If both are due at the same time, the
/// cycle runs first. A deadline of zero, which means "at once", is due at the time of the last call.
static_assert(implements<req::AOR_OUT_027>);
void Device::advance(const Instant now) noexcept {
    const Instant next = next_deadline();
    Instant due = (next > called_) ? next : called_;
    called_ = now;
    while (due <= now) {
        if (next_cycle_ <= due) {
            run_cycle(due);
        }
        node_.advance(due);
        watch_network(due);
        // A deadline that is still due after the call waits for another event, such as free space in the transmit
        // queue.
        due = earliest(if_later(node_.next_deadline(), due), if_later(next_cycle_, due));
    }
    node_.advance(now);
    watch_network(now);
}

Instant Device::next_deadline() const noexcept {
    return earliest(node_.next_deadline(), next_cycle_);
}

static_assert(implements<req::AOR_OUT_001> && implements<req::AOR_OUT_030> && implements<req::AOR_OUT_002>);
void Device::run_cycle(const Instant now) noexcept {
    const bool quiet = !run_blocks(now);
    tell_errors(now);
    // After two cycles in a row without a change, all further cycles would have the same result until a new event.
    const bool rests = quiet && was_quiet_;
    was_quiet_ = quiet;
    next_cycle_ = rests ? next_change() : (now + cycle_time);
}

/// Returns the next time at which a block changes without a new event: the end of a delay. A delay begins at the start
/// of a cycle and lasts a whole number of milliseconds, so it also ends at the start of a cycle.
Instant Device::next_change() const noexcept {
    return earliest(relay_.next_change(), earliest(universal_[0U].next_change(), universal_[1U].next_change()));
}

/// Evaluates all blocks once. Returns true when the next cycle can have another result, because a value keeps changing
/// or a change has not reached the blocks that come earlier in the order. Returns false when this cycle has processed
/// all changes completely, such as new inputs.
bool Device::run_blocks(const Instant now) noexcept {
    supervision_.advance(inputs_, objects_);
    bool changes{false};
    sources_.set_network(overdue_, silent_);
    for (std::uint8_t table = 1U; table <= table_count; ++table) {
        changes = tables_[table - 1U].advance(table, objects_, sources_, now) || changes;
    }
    for (std::uint8_t block = 1U; block <= logic_count; ++block) {
        changes = selections_[block - 1U].advance(block, objects_, sources_) || changes;
    }
    for (std::uint8_t block = 1U; block <= math_count; ++block) {
        changes = calculations_[block - 1U].advance(block, objects_, sources_) || changes;
    }
    const bool runs = (node_.state() == NmtState::operational) && (!has_left_);
    has_left_ = false;
    const OutputCycle cycle{supervision_.shuts_down() || (!runs), supervision_.has_power(), now};
    for (UniversalOutput& output : universal_) {
        changes = output.advance(cycle, inputs_, outputs_) || changes;
    }
    relay_.advance(cycle, outputs_);
    return changes;
}

static_assert(implements<req::AOR_DIAG_007> && implements<req::AOR_DIAG_012> && implements<req::AOR_DIAG_013>);
void Device::tell_errors(const Instant now) noexcept {
    if (node_.state() != NmtState::initialising) {
        node_.set_error(own::error::supply, supervision_.has_supply_fault(), now);
        static_assert(implements<req::AOR_DIAG_019> && implements<req::AOR_DIAG_021>);
        node_.set_error(own::error::temperature, supervision_.has_temperature_fault(), now);
    }
}

/// Wakes the blocks when a network fault that puts received values into the state "error" begins or ends. Also wakes
/// them when the node enters or leaves operational, because outputs work in operational only: the node can leave
/// operational without a change of those faults.
static_assert(implements<req::AOR_OUT_026> && implements<req::AOR_OUT_041> && implements<req::AOR_OUT_045>);
void Device::watch_network(const Instant now) noexcept {
    bool silent = node_.has_error(ErrorId::life_guarding);
    for (const ErrorId error : heartbeat_errors) {
        silent = silent || node_.has_error(error);
    }
    const std::uint8_t overdue = node_.overdue_rpdos();
    const bool runs = node_.state() == NmtState::operational;
    has_left_ = has_left_ || (runs_ && (!runs));
    if ((silent != silent_) || (std::uint32_t{overdue} != overdue_) || (runs != runs_)) {
        silent_ = silent;
        overdue_ = overdue;
        runs_ = runs;
        wake(now);
    }
}

/// Schedules the next cycle after an event at `now`.
void Device::wake(const Instant now) noexcept {
    const std::uint64_t cycles_gone = elapsed(epoch_, now).us / cycle_time.us;
    const Instant next = epoch_ + Duration{(cycles_gone + 1U) * cycle_time.us};
    static_assert(implements<req::AOR_OUT_053>);
    next_cycle_ = earliest(next_cycle_, earliest(next, now + cycle_time));
    was_quiet_ = false;
}

/// Stores 5B50h change baud rate and 5B51h change node-ID in the memory of LSS when a write to 1010h (store parameters)
/// saves the manufacturer parameters. The value of 5555h start in operational mode is then a stored one.
static_assert(implements<req::AOR_NODE_002>);
AbortCode Device::save(const ParameterGroups saved) {
    if (!has_group(saved, ParameterGroup::manufacturer)) {
        return AbortCode::none;
    }
    starts_itself_ = objects_.get(field::o5555_start_in_operational_mode);
    const LssConfiguration wanted{objects_.get(field::o5b51_change_node_id), wanted_bit_rate()};
    const bool differs = (std::uint32_t{wanted.node_id} != kept_.node_id) || (wanted.bit_rate != kept_.bit_rate);
    if (!differs) {
        return AbortCode::none;
    }
    if (lss_store_.store(wanted) != LssError::none) {
        static_assert(implements<req::AOR_NODE_008> && implements<req::AOR_NODE_010>);
        return AbortCode::hardware_error;
    }
    kept_ = wanted;
    return AbortCode::none;
}

static_assert(implements<req::AOR_ID_002>);
void Device::put_factory_values(const ParameterGroup group) {
    if (group == ParameterGroup::communication) {
        objects_.set_given(field::o1018_3_revision_number, factory_.revision);
        objects_.set_given(field::o1018_4_serial_number, factory_.serial_number);
        objects_.set_given(field::o1020_verify_configuration[1U], factory_.made_on);
        objects_.set_given(field::o1020_verify_configuration[2U], factory_.made_at);
    }
}

static_assert(implements<req::AOR_OUT_026> && implements<req::AOR_NODE_004>);
void Device::restart(const Instant now) {
    outputs_ = Outputs{};
    supervision_.reset();
    sources_.reset();
    LastMinimum last{};
    for (std::uint8_t table = 1U; table <= table_count; ++table) {
        tables_[table - 1U].reset(table, objects_);
        first_points_[table - 1U].begin(table, objects_, sources_, last);
    }
    for (CalculationBlock& calculation : calculations_) {
        calculation.reset();
    }
    for (std::uint8_t output = 1U; output <= output_count; ++output) {
        universal_[output - 1U].reset();
        types_[output - 1U] = objects_.get(field::o6310_ao_output_type[output]);
    }
    supervision_.advance(inputs_, objects_);
    relay_.reset(supervision_.has_power(), outputs_);
    static_assert(implements<req::AOR_NODE_007>);
    show_bit_rate();
    show_node_id();
    starts_itself_ = objects_.get(field::o5555_start_in_operational_mode);
    silent_ = false;
    overdue_ = 0U;
    runs_ = false;
    has_left_ = false;
    epoch_ = now;
    next_cycle_ = never;
    wake(now);
}

static_assert(implements<req::AOR_START_005> && implements<req::AOR_START_002> && implements<req::AOR_START_004>);
void Device::booted(const Instant now) {
    if (starts_itself_) {
        static_assert(implements<req::AOR_START_001>);
        node_.start_at(now);
    }
    tell_errors(now);
}

void Device::set_bit_rate(const std::uint32_t bit_rate, const Instant) {
    bit_rate_ = bit_rate;
}

/// Stores the settings of LSS. For a setting that LSS has not changed, two values stay as they are: the one stored by
/// 1010h (store parameters), and the one written to 5B50h (change baud rate) or 5B51h (change node-ID).
static_assert(implements<req::AOR_NODE_005> && implements<req::AOR_NODE_011> && implements<req::AOR_NODE_009>);
LssError Device::store_configuration(const LssConfiguration& configuration) {
    const bool stays_node_id = std::uint32_t{configuration.node_id} == lss_stored_.node_id;
    const bool stays_bit_rate = configuration.bit_rate == lss_stored_.bit_rate;
    const LssConfiguration wanted{stays_node_id ? kept_.node_id : configuration.node_id,
                                  stays_bit_rate ? kept_.bit_rate : configuration.bit_rate};
    const LssError error = lss_store_.store(wanted);
    if (error != LssError::none) {
        return error;
    }
    kept_ = wanted;
    lss_stored_ = configuration;
    static_assert(implements<req::AOR_NODE_012>);
    if (!stays_node_id) {
        show_node_id();
    }
    if (!stays_bit_rate) {
        show_bit_rate();
    }
    return error;
}

std::uint32_t Device::wanted_bit_rate() const noexcept {
    return cell_or(own::bit_rates::find(objects_.get(field::o5b50_change_baud_rate)), &own::bit_rates::Row::bit_rate,
                   kept_.bit_rate);
}

static_assert(implements<req::AOR_NODE_003>);
void Device::show_bit_rate() noexcept {
    for (const own::bit_rates::Row& row : own::bit_rates::rows) {
        if (row.bit_rate == kept_.bit_rate) {
            objects_.set(field::o5b50_change_baud_rate, row.index);
        }
    }
}

void Device::show_node_id() noexcept {
    objects_.set(field::o5b51_change_node_id, kept_.node_id);
}

}  // namespace canproof::ax130751
