// SPDX-License-Identifier: Apache-2.0
// Theorems on the state machine of the node: NMT commands that change the state, in any state of the node.
#include "firmware/canopen/node.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

/// Memory for stored parameters; no theorem here reads or writes it.
class NoMemory final : public NonVolatileMemory {
  public:
    std::size_t size() const override { return 0U; }
    bool read(const std::size_t /*at*/, MutableBytes /*to*/) const override { return false; }
    bool write(const std::size_t /*at*/, const ByteView /*bytes*/) override { return false; }
    bool commit() override { return false; }
};

class QuietApplication final : public Application {
  public:
    void set_bit_rate(const std::uint32_t /*bit_rate*/, const Instant /*now*/) override {}
    LssError store_configuration(const LssConfiguration& /*configuration*/) override { return LssError::none; }
    void after_write(const EntryRef& /*entry*/, Instant /*now*/) override {}
    void put_factory_values(ParameterGroup /*group*/) override {}
    void restart(Instant /*now*/) override {}
    void booted(Instant /*now*/) override {}
};

/// Invariant between two calls: the services that work are those of the NMT state, and error control shows this state.
/// No SDO transfer is open, and no self-start is planned, where the state forbids it.
bool is_consistent(const Node& node) {
    const AllowedServices allowed{node.state_};
    return (node.allowed_.has(NmtService::pdo) == allowed.has(NmtService::pdo)) &&
           (node.allowed_.has(NmtService::sdo) == allowed.has(NmtService::sdo)) &&
           (node.allowed_.has(NmtService::sync) == allowed.has(NmtService::sync)) &&
           (node.allowed_.has(NmtService::emcy) == allowed.has(NmtService::emcy)) &&
           ((node.state_ == NmtState::initialising) || (node.error_control_.state_ == node.state_)) &&
           (allowed.has(NmtService::sdo) || (node.sdo_.state_ == SdoServer::State::idle));
}

/// A node with PDOs that are not in use, in any state, with any values in its dictionary. No emergency message waits.
struct AnyNode {
    AnyDictionary dictionary{};
    NoMemory memory{};
    TransmitQueue queue{};
    QuietApplication application{};
    ErrorTable errors{any<ErrorTable>()};
    Node node{dictionary.objects, memory, queue, application, errors, NodeProfile{}, PdoMemory{}};

    AnyNode() {
        leave_open(node.state_);
        leave_open(node.allowed_);
        leave_open(node.can_state_);
        leave_open(node.start_at_);
        leave_open(node.idle_until_);
        leave_open(node.error_control_);
        leave_open(node.sdo_);
        leave_open(node.sync_);
        leave_open(node.lss_);
        leave_open(node.emcy_);
        node.emcy_.pending_count_ = 0U;
        assume(is_consistent(node));
    }
};

}  // namespace

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
    claim(is_consistent(node));
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
    claim(is_consistent(node));
}

}  // namespace canproof::proofs
