#include "firmware/canopen/node.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t error_register_index = 0x1001U;
constexpr std::uint32_t error_behaviour_index = 0x1029U;
constexpr std::uint32_t communication_error_subindex = 1U;
// Values of 1029h (CiA 301, 7.5.2.32).
constexpr std::uint32_t to_pre_operational = 0U;
constexpr std::uint32_t no_change = 1U;
constexpr std::uint32_t to_stopped = 2U;
constexpr std::uint32_t store_index = 0x1010U;

}  // namespace

Node::Node(ObjectDictionary& objects, NonVolatileMemory& memory, TransmitQueue& queue, Application& application,
           const ErrorTable& errors, const NodeProfile& profile, const PdoMemory& pdos) noexcept
    : ObjectAccess{},
      objects_{objects},
      queue_{queue},
      application_{application},
      profile_{profile},
      store_{objects, memory},
      sdo_{*this, queue, profile.block_sdo},
      emcy_{objects, queue, errors, profile.error_list, profile.emcy_content},
      sync_{objects, queue},
      error_control_{objects, queue},
      heartbeats_{objects},
      rpdos_{pdos.received, pdos.received_lines, objects, *this, queue, profile.rpdos_answering_remote},
      tpdos_{pdos.sent, pdos.sent_lines, objects, queue, profile.tpdo_trigger},
      lss_{profile.lss, objects, queue, application} {}

void Node::power_on(const LssConfiguration& stored, const Instant now) noexcept {
    lss_.power_on(stored);
    follow_switching(now);
    reset_node(now);
}

static_assert(implements<req::CO_PDO_030>);
void Node::load_group(const ParameterGroup group) noexcept {
    objects_.load_defaults(group, node_id_);
    application_.put_factory_values(group);
    store_.load(group, node_id_);
}

void Node::load_all() noexcept {
    load_group(ParameterGroup::communication);
    load_group(ParameterGroup::manufacturer);
    load_group(ParameterGroup::application);
}

static_assert(implements<req::CO_STORE_006> && implements<req::CO_LSS_065>);
void Node::tell_damage(const Instant now) noexcept {
    emcy_.set(ErrorId::stored_set_checksum, store_.is_damaged() || lss_.is_damaged(), now);
}

static_assert(implements<req::CO_NMT_005>);
void Node::reset_node(const Instant now) noexcept {
    lss_.restore(now);
    node_id_ = lss_.take_node_id();
    store_.open();
    load_all();
    if (store_.is_damaged()) {
        load_all();  // a value could not be read: nothing of that set is used
    }
    emcy_.enable(false, now);
    emcy_.reset();
    faults_ = CommunicationFaults{};
    communication_failed_ = false;
    application_.restart(now);
    tell_damage(now);
    emcy_.set(ErrorId::can_overrun, overrun_, now);  // what outlasts the reset is an error of the new life as well
    boot_up(now);
}

static_assert(implements<req::CO_NMT_006>);
void Node::reset_communication(const Instant now) noexcept {
    node_id_ = lss_.take_node_id();
    load_group(ParameterGroup::communication);
    if (store_.is_damaged()) {
        load_group(ParameterGroup::communication);
    }
    emcy_.refresh();
    tell_damage(now);
    boot_up(now);
}

static_assert(implements<req::CO_LSS_030> && implements<req::CO_K_LSS_UNCONFIGURED>);
void Node::boot_up(const Instant now) noexcept {
    wake();
    state_ = NmtState::initialising;
    allowed_ = AllowedServices{};
    start_at_ = never;
    sync_.allow(false, now);
    sdo_.reset(node_id_);
    emcy_.set_node_id(node_id_);
    heartbeats_.reset();
    rpdos_.reset();
    tpdos_.reset();
    if (node_id_ == unconfigured_node_id) {
        emcy_.enable(false, now);
        return;
    }
    emcy_.set(ErrorId::error_passive, can_state_ >= CanState::error_passive, now);  // initialising told of none
    error_control_.boot_up(node_id_, now);
    enter(NmtState::pre_operational, now);
    watch_communication(now);
    application_.booted(now);
}

static_assert(implements<req::CO_SDO_017>);
void Node::enter(const NmtState state, const Instant now) noexcept {
    wake();
    const bool had_pdos = allowed_.has(NmtService::pdo);
    allowed_ = AllowedServices{state};
    const bool has_pdos = allowed_.has(NmtService::pdo);
    state_ = state;
    error_control_.set_state(state);
    if (!allowed_.has(NmtService::sdo)) {
        sdo_.abandon();
    }
    if (!has_pdos) {
        rpdos_.stop();
        tpdos_.stop();
    } else if (!had_pdos) {
        tpdos_.start(now);
    } else {
        // the PDOs go on
    }
    sync_.allow(allowed_.has(NmtService::sync), now);
    emcy_.enable(allowed_.has(NmtService::emcy) && may_send(), now);
}

void Node::receive(const Frame& frame, const Instant now) noexcept {
    if (can_state_ == CanState::bus_off) {
        return;
    }
    advance(now);
    if (lss_.is_silent()) {
        return;
    }
    if (sdo_.is_request(frame)) {
        serve_sdo(frame, now);
    } else if (lss_.is_request(frame)) {
        configure(frame, now);
    } else if (state_ != NmtState::initialising) {
        serve(frame, now);
        watch_communication(now);
        send_events(now);
    } else {
        // without a node-ID nothing else is served
    }
}

void Node::configure(const Frame& frame, const Instant now) noexcept {
    wake();
    if (lss_.receive(frame, state_, now)) {
        reset_communication(now);
    } else {
        follow_switching(now);
    }
}

/// A change of the bit rate begins or ends: what waits to be sent at its beginning is dropped (CO-D-LSS-006).
void Node::switch_bit_rate(const Instant now) noexcept {
    switching_ = lss_.is_silent();
    if (may_send()) {
        queue_.open();
    } else {
        queue_.close();
        sdo_.abandon();
    }
    emcy_.enable(allowed_.has(NmtService::emcy) && may_send(), now);
}

/// What no service takes, 29-bit identifiers and TIME among it, has no effect.
static_assert(implements<req::CO_FRAME_001> && implements<req::CO_TIME_001>);
void Node::serve(const Frame& frame, const Instant now) noexcept {
    if (frame.id == generated::canopen::nmt_command_cob_id) {
        const auto command = nmt_command(frame, node_id_);
        if (command.has_value()) {
            obey(*command, now);
        }
        return;
    }
    if (allowed_.has(NmtService::sync) && sync_.is_sync(frame)) {
        serve_sync(frame, now);
    } else if (error_control_.receive(frame, now)) {
        wake();
    } else {
        serve_pdo(frame, now);
    }
}

void Node::serve_sync(const Frame& frame, const Instant now) noexcept {
    wake();
    const bool has_length = sync_.has_length(frame);
    set_error(ErrorId::sync_length, !has_length, now);
    if (has_length) {
        consume_sync(sync_.counter_of(frame), now);
    }
}

/// A heartbeat may have the identifier of a PDO; each is served.
void Node::serve_pdo(const Frame& frame, const Instant now) noexcept {
    heartbeats_.receive(frame, now);
    idle_until_ = earliest(idle_until_, heartbeats_.next_deadline());
    if (allowed_.has(NmtService::pdo)) {
        rpdos_.receive(frame, now);
        if (frame.remote) {
            tpdos_.answer(frame, now);
        }
        idle_until_ = earliest(idle_until_, rpdos_.next_deadline());
    }
}

static_assert(implements<req::CO_NMT_002>);
void Node::obey(const NmtCommand command, const Instant now) noexcept {
    wake();
    start_at_ = never;  // the master has taken over: no self-start any more
    switch (command) {
        case NmtCommand::start:
            enter(NmtState::operational, now);
            break;
        case NmtCommand::stop:
            enter(NmtState::stopped, now);
            break;
        case NmtCommand::enter_pre_operational:
            enter(NmtState::pre_operational, now);
            break;
        case NmtCommand::reset_node:
            reset_node(now);
            break;
        case NmtCommand::reset_communication:
            reset_communication(now);
            break;
        default:
            break;
    }
}

static_assert(implements<req::CO_PDO_029>);
void Node::consume_sync(const std::uint8_t counter, const Instant now) noexcept {
    if (allowed_.has(NmtService::pdo)) {
        tpdos_.sync(counter);
        rpdos_.sync(now);
    }
}

void Node::act(const Instant now) noexcept {
    lss_.advance(now);
    follow_switching(now);
    if (state_ == NmtState::initialising) {
        idle_until_ = lss_.next_deadline();
        return;
    }
    if (start_at_ <= now) {
        start_at_ = never;
        enter(NmtState::operational, now);
    }
    error_control_.advance(now);
    heartbeats_.advance(now);
    sdo_.advance(now);
    if (sync_.advance(now)) {
        consume_sync(sync_.produced_counter(), now);
    }
    rpdos_.advance(now);
    emcy_.advance(now);
    watch_communication(now);
    send_events(now);
    // A block upload goes on as soon as there is room: nothing else needs to be looked at to know that.
    const Instant segments = sdo_.idle_until();
    idle_until_ = (segments <= now) ? segments : earliest(segments, next_without_tpdos());
}

void Node::tell_register(const Instant now) noexcept {
    tpdos_.value_changed(error_register_index, 0U, now);
}

Instant Node::next_without_tpdos() const noexcept {
    if (state_ == NmtState::initialising) {
        return lss_.next_deadline();
    }
    Instant next = earliest(start_at_, error_control_.next_deadline());
    next = earliest(next, lss_.next_deadline());
    next = earliest(next, heartbeats_.next_deadline());
    next = earliest(next, sdo_.next_deadline());
    next = earliest(next, sync_.next_deadline());
    next = earliest(next, rpdos_.next_deadline());
    return earliest(next, emcy_.next_deadline());
}

void Node::start_at(const Instant at) noexcept {
    wake();
    const bool held = communication_failed_ && (error_behaviour(communication_error_subindex) != no_change);
    start_at_ = held ? never : at;
}

void Node::change_error(const ErrorId error, const bool present, const Instant now) noexcept {
    emcy_.set(error, present, now);
    wake();
}

void Node::set_overrun(const bool lost, const Instant now) noexcept {
    overrun_ = lost;
    set_error(ErrorId::can_overrun, lost, now);
}

void Node::set_controller(const std::uint8_t state, const bool overrun, const Instant now) noexcept {
    constexpr std::uint32_t worst = static_cast<std::uint8_t>(CanState::bus_off);
    set_can_state(static_cast<CanState>((state < worst) ? state : worst), now);
    set_overrun(overrun, now);
}

void Node::set_can_state(const CanState state, const Instant now) noexcept {
    if (state == can_state_) {
        return;
    }
    const bool was_off = can_state_ == CanState::bus_off;
    const bool is_off = state == CanState::bus_off;
    can_state_ = state;
    wake();
    if (may_send()) {
        queue_.open();
    } else {
        queue_.close();
    }
    if (state_ == NmtState::initialising) {
        return;
    }
    if (is_off) {
        sdo_.abandon();
    }
    emcy_.enable(allowed_.has(NmtService::emcy) && may_send(), now);
    if (was_off) {
        emcy_.report(ErrorId::bus_off_recovered, now);
    }
    emcy_.set(ErrorId::error_passive, state >= CanState::error_passive, now);
    watch_communication(now);
}

void Node::take_note(const CommunicationFaults faults, const Instant now) noexcept {
    wake();
    faults_ = faults;
    announce(faults, now);
    const bool failed = faults.is_error();
    if (failed == communication_failed_) {
        return;
    }
    communication_failed_ = failed;
    if (failed) {
        apply_error_behaviour(communication_error_subindex, now);
    }
    application_.communication_failed(failed, now);
}

void Node::announce(const CommunicationFaults faults, const Instant now) noexcept {
    using Faults = CommunicationFaults;
    emcy_.set(ErrorId::guard_or_heartbeat, faults.has(Faults::guarding | Faults::silent_producers), now);
    emcy_.set(ErrorId::life_guarding, faults.has(Faults::guarding), now);
    for (std::size_t slot = 0U; slot < HeartbeatConsumer::max_producers; ++slot) {
        const bool silent = faults.has(1U << slot);
        emcy_.set(error_after(ErrorId::heartbeat_1, slot), silent, now, heartbeats_.producer(slot));
    }
    emcy_.set(ErrorId::rpdo_length, faults.has(Faults::rpdo_short), now);
    emcy_.set(ErrorId::rpdo_value, faults.has(Faults::rpdo_refused), now);
    emcy_.set(ErrorId::rpdo_timeout, faults.has(Faults::rpdo_overdue), now);
}

/// An entry that is absent reads as zero: to pre-operational.
std::uint32_t Node::error_behaviour(const std::uint8_t subindex) const noexcept {
    return objects_.read(error_behaviour_index, subindex);
}

void Node::apply_error_behaviour(const std::uint8_t subindex, const Instant now) noexcept {
    const std::uint32_t wanted = error_behaviour(subindex);
    if (wanted != no_change) {
        start_at_ = never;  // 1029h outranks the self-start
    }
    if ((wanted == to_pre_operational) && (state_ == NmtState::operational)) {
        enter(NmtState::pre_operational, now);
    } else if (wanted == to_stopped) {
        enter(NmtState::stopped, now);
    } else {
        // no change of state
    }
}

AbortCode Node::check_program(const EntryRef& entry) noexcept {
    return application_.check_access(entry);
}

static_assert(implements<req::CO_SDO_009>);
Result<ByteView, AbortCode> Node::read(const std::uint16_t index, const std::uint8_t subindex) {
    using Read = Result<ByteView, AbortCode>;
    const EntryRef entry = objects_.lookup(index, subindex);
    const AbortCode code = check_access(entry, index);
    if (code != AbortCode::none) {
        return Read::failure(code);
    }
    if (!entry.may(rights::read)) {
        return Read::failure(AbortCode::write_only);
    }
    return (entry.row->type == DataType::domain) ? application_.domain_value(entry)
                                                 : Read::success(objects_.value(entry));
}

Result<WritePlace, AbortCode> Node::writable(const std::uint16_t index, const std::uint8_t subindex) {
    using Place = Result<WritePlace, AbortCode>;
    const EntryRef entry = objects_.lookup(index, subindex);
    const AbortCode code = check_access(entry, index);
    if (code != AbortCode::none) {
        return Place::failure(code);
    }
    if (!entry.may(rights::write)) {
        return Place::failure(AbortCode::read_only);
    }
    if (entry.row->type == DataType::domain) {
        const MutableBytes staging = application_.staging(entry);
        return (staging.size() > 0U) ? Place::success(WritePlace{staging.size(), staging})
                                     : Place::failure(AbortCode::out_of_memory);
    }
    const bool is_long = entry.row->size > SdoServer::buffer_size;
    return Place::success(WritePlace{entry.row->size, is_long ? application_.staging(entry) : MutableBytes{}});
}

static_assert(implements<req::CO_SDO_033>);
AbortCode Node::write_domain(const EntryRef& entry, const ByteView value, const Instant now) noexcept {
    MutableBytes staging = application_.staging(entry);
    if (staging.size() == 0U) {
        return AbortCode::out_of_memory;
    }
    if (value.size() > staging.size()) {
        return AbortCode::too_long;
    }
    if (value.data() != staging.view().data()) {
        staging.copy(0U, value);  // an expedited download: its bytes are still in the frame
    }
    return application_.commit(entry, value.size(), now);
}

static_assert(implements<req::CO_SDO_016>);
AbortCode Node::write(const std::uint16_t index, const std::uint8_t subindex, const ByteView value, const Instant now) {
    const EntryRef entry = objects_.lookup(index, subindex);
    AbortCode code = check_access(entry, index);
    if (code != AbortCode::none) {
        return code;
    }
    const bool is_number = !has_variable_length(entry.row->type);
    if (!is_number && (entry.row->type == DataType::domain) && entry.may(rights::write)) {
        return write_domain(entry, value, now);
    }
    std::uint64_t number{0U};
    code = objects_.check_length(*entry.row, value.size());
    if ((code == AbortCode::none) && is_number) {
        number = read_le(value, 0U, value.size());
        code = objects_.check_bits(*entry.row, number);
    }
    if (code != AbortCode::none) {
        return code;
    }
    if (entry.row->service == Service::store) {
        return store(entry, static_cast<std::uint32_t>(number));  // a signature is obeyed, not kept
    }
    if (entry.row->service != Service::none) {
        code = before_write(entry, value);
        if (code != AbortCode::none) {
            return code;
        }
    }
    const bool changes = is_number ? objects_.put_bits(*entry.row, number) : objects_.put(entry, value);
    after_put(entry, changes, now);
    if (changes && entry.may(rights::stored) && !entry.may(rights::rpdo)) {
        forget_verification(index);
    }
    return AbortCode::none;
}

/// Date and time of the configuration tool mean the configuration that it left, no other. Process values, which an RPDO
/// may carry, are none.
static_assert(implements<req::CO_VERIFY_001> && implements<req::CO_VERIFY_002> && implements<req::CO_VERIFY_003>);
void Node::forget_verification(const std::uint16_t changed_index) noexcept {
    constexpr std::uint32_t verify_index = 0x1020U;
    constexpr std::uint32_t parts = 2U;  // date, time
    for (std::uint8_t subindex = 1U; (changed_index != verify_index) && (subindex <= parts); ++subindex) {
        const EntryRef found = objects_.lookup(verify_index, subindex);
        if (found.exists() && found.may(rights::write)) {
            static_cast<void>(objects_.put_bits(*found.row, 0U));
        }
    }
}

AbortCode Node::store(const EntryRef& entry, const std::uint32_t value) noexcept {
    const bool wrong_state = profile_.saves_in_pre_operational_only && (state_ != NmtState::pre_operational);
    if (wrong_state && (entry.index == store_index)) {
        return AbortCode::device_state;
    }
    const AbortCode code = store_.execute(entry, value);
    return ((code == AbortCode::none) && (entry.index == store_index)) ? application_.save(entry) : code;
}

AbortCode Node::before_received(const EntryRef& entry, const std::uint64_t bits) {
    std::array<std::uint8_t, sizeof(bits)> bytes{};
    MutableBytes{bytes}.put_le<sizeof(bits)>(0U, bits);
    return before_write(entry, ByteView{bytes.data(), entry.row->size});
}

AbortCode Node::before_write(const EntryRef& entry, const ByteView value) noexcept {
    const bool is_devices = (entry.row->service == Service::device) || (entry.row->service == Service::program);
    return is_devices ? application_.before_write(entry, value)
                      : check_parameter(entry, static_cast<std::uint32_t>(read_le(value, 0U, value.size())));
}

/// What the service that owns a parameter, which is a number of at most 32 bits, says of a new value.
AbortCode Node::check_parameter(const EntryRef& entry, const std::uint32_t value) const noexcept {
    switch (entry.row->service) {
        case Service::sync:
            return sync_.before_write(entry, value);
        case Service::emcy:
            return emcy_.before_write(entry, value);
        case Service::heartbeat:
            return (entry.index == HeartbeatConsumer::index) ? heartbeats_.before_write(entry, value) : AbortCode::none;
        case Service::guarding:
            return error_control_.before_write(entry, value);
        case Service::pdo:
            return check_pdo_write(objects_, entry, value);
        case Service::none:
        case Service::store:
        case Service::nmt:
        case Service::error_behaviour:
        case Service::program:
        case Service::lss:
        case Service::device:
        default:
            return AbortCode::none;
    }
}

void Node::after_write(const EntryRef& entry, const Instant now) noexcept {
    switch (entry.row->service) {
        case Service::sync:
            sync_.after_write(now);
            break;
        case Service::emcy:
            emcy_.after_write(entry);
            break;
        case Service::heartbeat:
            if (entry.index == HeartbeatConsumer::index) {
                heartbeats_.after_write(entry);
            } else {
                error_control_.after_write(entry, now);
            }
            break;
        case Service::guarding:
            error_control_.after_write(entry, now);
            break;
        case Service::program:
        case Service::device:
            application_.after_write(entry, now);
            break;
        case Service::pdo:
            rpdos_.after_write(entry);
            tpdos_.after_write(entry, now);
            break;
        case Service::none:
        case Service::store:
        case Service::nmt:
        case Service::error_behaviour:
        case Service::lss:
        default:
            break;
    }
}

}  // namespace canproof
