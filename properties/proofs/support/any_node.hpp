// SPDX-License-Identifier: Apache-2.0
// A node in any state, without PDOs, with the dictionary of the CAN-CBX-AO412.
#pragma once

#include "firmware/canopen/node.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

/// A non-volatile memory without stored parameters: nothing was ever stored in it, or it cannot be read.
class EmptyMemory final : public NonVolatileMemory {
  public:
    std::size_t size() const override { return 0U; }
    bool read(const std::size_t /*at*/, MutableBytes to) const override {
        for (std::size_t i = 0U; i < to.size(); ++i) {
            to.set(i, 0xFFU);
        }
        return is_readable_;
    }
    bool write(const std::size_t /*at*/, const ByteView /*bytes*/) override { return false; }
    bool commit() override { return false; }

    bool is_readable_{true};
};

class QuietApplication : public Application {
  public:
    void set_bit_rate(const std::uint32_t /*bit_rate*/, const Instant /*now*/) override {}
    LssError store_configuration(const LssConfiguration& /*configuration*/) override { return LssError::none; }
    void after_write(const EntryRef& /*entry*/, Instant /*now*/) override {}
    void put_factory_values(ParameterGroup /*group*/) override {}
    void restart(Instant /*now*/) override {}
    void booted(Instant /*now*/) override {}
};

/// A node in any state, with any values in its dictionary. Its PDOs are not in use, and no emergency message waits.
struct AnyNode {
    AnyDictionary dictionary{};
    EmptyMemory memory{};
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
        assume(node.is_consistent());
    }
};

}  // namespace canproof::proofs
