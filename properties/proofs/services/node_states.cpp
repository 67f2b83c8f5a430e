// SPDX-License-Identifier: Apache-2.0
// Theorems on the NMT state machine: the effect of NMT commands in any state of the node.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/any_node.hpp"

namespace canproof::proofs {

void an_nmt_command_leads_to_its_state() {
    shows(
        "start, stop and enter pre-operational lead from any state to their own, and the services follow, in a node "
        "without PDOs and with no emergency message waiting");
    proves<req::CO_NMT_002, req::CO_NMT_008>();
    AnyNode any_node{};
    Node& node = any_node.node;
    const auto command = any<NmtCommand>();
    assume((command == NmtCommand::start) || (command == NmtCommand::stop) ||
           (command == NmtCommand::enter_pre_operational));
    node.obey(command, any_time());
    const NmtState expected = (command == NmtCommand::start)  ? NmtState::operational
                              : (command == NmtCommand::stop) ? NmtState::stopped
                                                              : NmtState::pre_operational;
    claim(node.state_ == expected);
    claim(node.start_at_ == never);
    claim(node.is_consistent());
    claim(any_node.queue.empty());
}

void an_error_behaviour_leads_to_its_state() {
    shows(
        "1029h error behaviour leads to pre-operational from operational alone, to stopped from each state, or "
        "nowhere, in a node without PDOs and with no emergency message waiting");
    proves<req::CO_NMT_007>();
    AnyNode any_node{};
    Node& node = any_node.node;
    const auto subindex = any<std::uint8_t>();
    const NmtState before = node.state_;
    const std::uint32_t wanted = any_node.dictionary.objects.read(0x1029U, subindex);
    node.apply_error_behaviour(subindex, any_time());
    const bool falls = (wanted == 0U) && (before == NmtState::operational);
    claim(node.state_ == (falls ? NmtState::pre_operational : ((wanted == 2U) ? NmtState::stopped : before)));
    claim((wanted == 1U) || (node.start_at_ == never));
    claim(node.is_consistent());
}

void an_nmt_command_keeps_each_service_consistent() {
    shows(
        "start, stop and enter pre-operational leave every service of a node consistent that was consistent before, in "
        "a node without PDOs and with no emergency message waiting");
    proves<req::CO_NMT_002>();
    AnyNode any_node{};
    Node& node = any_node.node;
    const auto command = any<NmtCommand>();
    assume((command == NmtCommand::start) || (command == NmtCommand::stop) ||
           (command == NmtCommand::enter_pre_operational));
    leave_open(node.heartbeats_);
    assume((node.state_ != NmtState::initialising) && (node.inconsistent_service() == nullptr));
    node.obey(command, any_time());
    claim(node.inconsistent_service() == nullptr);
}

}  // namespace canproof::proofs
