// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/node.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

}  // namespace

Node::Node(ObjectDictionary& objects, NonVolatileMemory& memory, TransmitQueue& queue, Application& application,
           const ErrorTable& errors, const NodeProfile& profile, const PdoMemory& pdos) noexcept
    : ObjectAccess{},
      objects_{objects},
      queue_{queue},
      application_{application},
      profile_{profile},
      store_{objects, memory},
      sync_{objects, queue},
      error_control_{objects, queue},
      heartbeats_{objects},
      rpdos_{pdos.received, pdos.received_lines, objects, *this, queue, profile.rpdos_answering_remote},
      tpdos_{pdos.sent, pdos.sent_lines, objects, queue, profile.tpdo_trigger},
      lss_{profile.lss, objects, queue, application},
      sdo_{*this, queue, profile.block_sdo},
      emcy_{objects, queue, errors, profile.error_list, profile.emcy_content} {}

void Node::switch_on(const LssConfiguration& stored, const Instant now) noexcept {
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

static_assert(implements<req::CO_STORE_016> && implements<req::CO_LSS_087>);
void Node::tell_damage(const Instant now) noexcept {
    emcy_.set(ErrorId::stored_set_checksum, store_.is_damaged() || lss_.is_damaged(), now);
}

static_assert(implements<req::CO_NMT_005> && implements<req::CO_STORE_006>);
void Node::reset_node(const Instant now) noexcept {
    lss_.restore(now);
    node_id_ = lss_.take_node_id();
    store_.open();
    load_all();
    if (store_.is_damaged()) {
        load_all();  // a stored value could not be read: the node uses no value of the stored set
    }
    emcy_.reset();
    faults_ = CommunicationFaults{};
    communication_failed_ = false;
    application_.restart(now);
    tell_damage(now);
    emcy_.set(ErrorId::can_overrun, overrun_, now);  // an overrun that lasts beyond the reset is reported again
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
        return;
    }
    // While the node was initialising it could not report that the controller became error passive. It reports this
    // now.
    emcy_.set(ErrorId::error_passive, can_state_ >= CanState::error_passive, now);
    emcy_.take_back();
    error_control_.boot_up(node_id_, now);
    static_assert(implements<req::CO_NMT_012>);
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
        // the PDOs keep running
    }
    sync_.allow(allowed_.has(NmtService::sync), now);
    admit_services(now);
}

/// Enables EMCY and SDO if they work in the present NMT state and the node may send; otherwise disables them.
void Node::admit_services(const Instant now) noexcept {
    static_assert(implements<req::CO_EMCY_031>);
    emcy_.enable(allowed_.has(NmtService::emcy) && may_send(), now);
    static_assert(implements<req::CO_SDO_045>);
    sdo_.listen(allowed_.has(NmtService::sdo) && may_send());
}

/// Passes an SDO request to the function that serves it. Returns true when the request may have written an entry. An
/// upload and most segments of a transfer write none.
inline bool Node::serve_sdo(const Frame& frame, const Instant now) noexcept {
    if (sdo_.receive_segment(frame, now)) {
        return false;
    }
    const sdo::ClientCommand command = sdo::command_of(frame.data);
    if (command == sdo::ClientCommand::initiate_download) {
        sdo_.initiate_download(frame.data, now);
        return true;
    }
    if (command == sdo::ClientCommand::initiate_upload) {
        serve_upload(frame.data, now);
        return false;
    }
    sdo_.receive_command(frame.data, now);
    return true;
}

static_assert(implements<req::CO_LSS_074>);
void Node::receive(const Frame& frame, const Instant now) noexcept {
    if (can_state_ == CanState::bus_off) {
        return;
    }
    advance(now);
    bool is_served{false};
    if (sdo_.is_request(frame)) {
        is_served = serve_sdo(frame, now);
    } else if (lss_.is_silent()) {
        // the frame is ignored while the node changes its bit rate
    } else if (lss_.is_request(frame)) {
        configure(frame, now);
    } else if (state_ != NmtState::initialising) {
        serve(frame, now);
        if (rpdos_.take_change()) {
            wake();
        }
        is_served = true;
    } else {
        // a node without a node-ID serves only LSS requests
    }
    if (is_served) {
        settle(now);
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

/// Opens or closes the transmit queue when a change of the bit rate ends or begins. Frames that wait when the change
/// begins are dropped (CO-D-LSS-006).
void Node::switch_bit_rate(const Instant now) noexcept {
    switching_ = lss_.is_silent();
    if (may_send()) {
        queue_.open();
    } else {
        emcy_.take_back();
        queue_.close();
        sdo_.abandon();
    }
    admit_services(now);
}

/// Passes a frame to the service that it belongs to. Frames of no service have no effect, for example frames with a
/// 29-bit identifier, and TIME unless an RPDO or SYNC has its identifier.
static_assert(implements<req::CO_FRAME_001> && implements<req::CO_TIME_001>);
inline void Node::serve(const Frame& frame, const Instant now) noexcept {
    if (frame.id == generated::canopen::nmt_command_cob_id) {
        const auto command = nmt_command(frame, node_id_);
        if (command.has_value()) {
            obey(*command, now);
        }
        return;
    }
    if (allowed_.has(NmtService::sync) && sync_.is_sync(frame)) {
        serve_sync(frame, now);
    } else if (frame.is_plain()) {
        serve_data(frame, now);
    } else if (frame.remote) {
        serve_remote(frame, now);
    } else {
        // no service has a 29-bit identifier
    }
}

void Node::serve_sync(const Frame& frame, const Instant now) noexcept {
    const bool has_length = sync_.has_length(frame);
    set_error(ErrorId::sync_length, !has_length, now);
    if (has_length) {
        consume_sync(sync_.counter_of(frame), now);
    }
}

void Node::serve_remote(const Frame& request, const Instant now) noexcept {
    if (error_control_.answer(request, now)) {
        wake();
    } else if (allowed_.has(NmtService::pdo)) {
        rpdos_.answer(request);
        tpdos_.answer(request, now);
    } else {
        // no service answers this remote frame in the present NMT state
    }
}

/// Passes a data frame to the heartbeat consumer and to the PDOs: both may use the same identifier.
inline void Node::serve_data(const Frame& frame, const Instant now) noexcept {
    if (heartbeats_.receive(frame, now)) {
        wake();
    }
    if (allowed_.has(NmtService::pdo)) {
        static_assert(implements<req::CO_PDO_003>);
        rpdos_.receive(frame, now);
    }
}

static_assert(implements<req::CO_NMT_002>);
void Node::obey(const NmtCommand command, const Instant now) noexcept {
    static_assert(implements<req::CO_NMT_008>);
    start_at_ = never;  // an NMT command of the master cancels the self-start
    wake();
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
        tpdos_.sync(counter, sync_.counts());
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
        static_assert(implements<req::CO_NMT_011>);
        if (!error_prevents_start()) {
            enter(NmtState::operational, now);
        }
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
    tell_register(now);
    idle_until_ = next_of_others();
}

void Node::register_changed(const Instant now) noexcept {
    tpdos_.value_changed(index::error_register, 0U, now);
}

Instant Node::next_of_others() const noexcept {
    if (state_ == NmtState::initialising) {
        return lss_.next_deadline();
    }
    Instant next = earliest(start_at_, error_control_.next_deadline());
    next = earliest(next, lss_.next_deadline());
    next = earliest(next, heartbeats_.next_deadline());
    next = earliest(next, sync_.next_deadline());
    next = earliest(next, rpdos_.next_deadline());
    return earliest(next, emcy_.next_deadline());
}

}  // namespace canproof
