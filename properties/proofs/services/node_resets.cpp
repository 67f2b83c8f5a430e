// SPDX-License-Identifier: Apache-2.0
// Theorems on NMT reset node and reset communication, in any state of a node without PDOs.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/any_node.hpp"

namespace canproof::proofs {

namespace {

/// Claims that a node has booted: it is pre-operational, and the first frame that it sends is its boot-up message (700h
/// + node-ID, one byte 0).
void claim_booted(const AnyNode& any_node) {
    const Node& node = any_node.node;
    claim(node.state_ == NmtState::pre_operational);
    claim(node.start_at_ == never);
    claim(is_consistent(node));
    claim(any_node.queue.boot_up_waits());
    const Frame& first = waiting(any_node.queue, 0U);
    claim((first.id == (0x700U + node.node_id())) && (first.length == 1U) && (first.data[0] == 0U));
    claim(!first.extended && !first.remote);
}

/// Assumes a bus that works, a node without errors, and any node-ID that LSS or the switches can give.
void settle(AnyNode& any_node) {
    Node& node = any_node.node;
    assume(is_lss_node_id(node.lss_.stored_.node_id) && is_lss_node_id(node.lss_.pending_.node_id));
    assume((node.lss_.stored_.node_id <= 127U) && (node.lss_.pending_.node_id <= 127U));
    assume((node.can_state_ != CanState::bus_off) && !node.lss_.is_silent());
    node.emcy_.active_ = 0U;
}

}  // namespace

void a_reset_of_the_node_boots_it() {
    shows(
        "reset node leads from any state to pre-operational with the boot-up message first and the defaults in use, "
        "in a node without PDOs and without a stored set");
    proves<req::CO_NMT_005>();
    AnyNode any_node{};
    settle(any_node);
    any_node.node.obey(NmtCommand::reset_node, any_time());
    claim_booted(any_node);
    claim(any_node.node.node_id() == any_node.node.lss_.stored_.node_id);
    claim(any_node.dictionary.objects.read(0x1017U, 0U) == 0U);
}

void a_reset_of_the_communication_boots_it() {
    shows(
        "reset communication leads from any state to pre-operational with the boot-up message first, and leaves each "
        "value of 2000h and above as it is, in a node without PDOs and without a stored set");
    proves<req::CO_NMT_006>();
    AnyNode any_node{};
    settle(any_node);
    const std::uint8_t node_id = any_node.node.lss_.pending_.node_id;
    const std::uint32_t before = any_node.dictionary.objects.read(0x2404U, 1U);
    any_node.node.obey(NmtCommand::reset_communication, any_time());
    claim_booted(any_node);
    claim(any_node.node.node_id() == node_id);
    claim(any_node.dictionary.objects.read(0x2404U, 1U) == before);
}

}  // namespace canproof::proofs
