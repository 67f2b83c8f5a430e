// SPDX-License-Identifier: Apache-2.0
// Theorems on NMT reset node and reset communication, in any state of a node without PDOs.
#include "properties/proofs/support/node_resets.hpp"

#include "generated/canopen/requirements.hpp"

namespace canproof::proofs {

void a_reset_of_the_node_boots_it() {
    shows(
        "reset node leads from any state to pre-operational with the boot-up message first and the defaults in use, "
        "in a node without PDOs and without a stored set; if every service was consistent, and the node watched no "
        "heartbeat, every service is consistent again");
    proves<req::CO_NMT_005>();
    AnyNode any_node{};
    settle(any_node);
    const bool was_consistent = any_node.node.inconsistent_service() == nullptr;
    any_node.node.obey(NmtCommand::reset_node, any_time());
    claim_booted(any_node);
    claim(!was_consistent || (any_node.node.inconsistent_service() == nullptr));
    claim(any_node.node.node_id() == any_node.node.lss_.stored_.node_id);
    claim(any_node.dictionary.objects.read(0x1017U, 0U) == 0U);
}

}  // namespace canproof::proofs
