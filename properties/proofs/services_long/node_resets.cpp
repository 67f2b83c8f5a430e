// SPDX-License-Identifier: Apache-2.0
// Theorem on NMT reset communication, in any state of a node without PDOs, whose proof takes minutes.
#include "properties/proofs/support/node_resets.hpp"

#include "generated/canopen/requirements.hpp"

namespace canproof::proofs {

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
