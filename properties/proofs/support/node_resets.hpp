// SPDX-License-Identifier: Apache-2.0
// Conditions before and after a reset of a node without PDOs.
#pragma once

#include "properties/proofs/support/any_node.hpp"

namespace canproof::proofs {

/// Claims that a node has booted: it is pre-operational, and the first frame that it sends is its boot-up message (700h
/// + node-ID, one byte 0).
inline void claim_booted(const AnyNode& any_node) {
    const Node& node = any_node.node;
    claim(node.state_ == NmtState::pre_operational);
    claim(node.start_at_ == never);
    claim(node.is_consistent());
    claim(any_node.queue.boot_up_waits());
    const Frame& first = waiting(any_node.queue, 0U);
    claim((first.id == (0x700U + node.node_id())) && (first.length == 1U) && (first.data[0] == 0U));
    claim(!first.extended && !first.remote);
}

/// Assumes a bus that works, a node without errors, and any node-ID that LSS or the switches can give.
inline void settle(AnyNode& any_node) {
    Node& node = any_node.node;
    assume(is_lss_node_id(node.lss_.stored_.node_id) && is_lss_node_id(node.lss_.pending_.node_id));
    assume((node.lss_.stored_.node_id <= 127U) && (node.lss_.pending_.node_id <= 127U));
    assume((node.can_state_ != CanState::bus_off) && !node.lss_.is_silent());
    node.emcy_.active_ = 0U;
}

}  // namespace canproof::proofs
