// A CANopen node from any description: the whole protocol layer, plain storage behind its objects.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"
#include "host/codegen/dictionary_rows.hpp"

namespace canproof::host {

/// The emergency codes that CiA 301 gives to the errors every node can notice (7.2.7.1, Table 26).
ErrorTable standard_errors();

/// The dictionary of a generic device and what its node offers.
struct GenericDescription {
    DictionaryRows rows;
    NodeProfile profile;
};

/// With LSS, the bit rates are those of CiA 305 and nothing resets the node but its master.
GenericDescription describe(const Part& part);
/// The bit rates of CiA 305, and nothing resets the node but its master.
LssProfile standard_lss();

class GenericDevice final : private Application {
  public:
    GenericDevice(const Part& part, NonVolatileMemory& memory, TransmitQueue& queue);
    GenericDevice(GenericDescription description, NonVolatileMemory& memory, TransmitQueue& queue);

    void power_on(std::uint8_t node_id, Instant now) { power_on(LssConfiguration{node_id}, now); }
    /// With what an earlier life stored, and the controller as Node::set_controller() takes it; `bit_rate()` is then
    /// that of `stored`.
    void power_on(const LssConfiguration& stored, Instant now, std::uint8_t can_state = 0, bool overrun = false);
    void receive(const Frame& frame, Instant now) { node_.receive(frame, now); }
    void advance(Instant now) { node_.advance(now); }
    Instant next_deadline() const { return node_.next_deadline(); }

    Node& node() { return node_; }
    const Node& node() const { return node_; }
    ObjectDictionary& objects() { return objects_; }
    const ObjectDictionary& objects() const { return objects_; }
    /// Gives a DOMAIN entry a memory of `size` bytes, holding nothing yet.
    void lend(std::uint16_t index, std::uint8_t subindex, std::size_t size);
    /// Takes the memory of every DOMAIN now: nothing allocates any more.
    void take_domain_memory();
    /// What that entry holds; empty when it holds nothing.
    ByteView held(std::uint16_t index, std::uint8_t subindex) const;
    /// As a download would put it there.
    void fill(std::uint16_t index, std::uint8_t subindex, const std::vector<std::uint8_t>& bytes);
    /// As it was before anything was put there.
    void empty(std::uint16_t index, std::uint8_t subindex);
    /// What commit() answers from now on: AbortCode::none takes every new value.
    void refuse_domains_with(AbortCode code) { domain_refusal_ = code; }

    /// bit/s as LSS last set it.
    std::uint32_t bit_rate() const { return bit_rate_; }
    /// What LSS last stored.
    const LssConfiguration& stored() const { return stored_; }
    /// Store configuration goes to `store` from now on, which must live as long.
    void store_in(LssStore& store) { store_ = &store; }
    /// What store configuration answers without a store; only LssError::none keeps anything.
    void answer_store_with(LssError error) { store_answer_ = error; }

    /// How often a communication error began or ended.
    int communication_errors() const { return communication_errors_; }

  private:
    void after_write(const EntryRef&, Instant) override {}
    void put_factory_values(ParameterGroup) override {}
    void restart(Instant) override {}
    void booted(Instant) override {}
    void communication_failed(bool, Instant) override { ++communication_errors_; }
    void set_bit_rate(std::uint32_t bit_rate, Instant) override { bit_rate_ = bit_rate; }
    LssError store_configuration(const LssConfiguration& configuration) override;
    Result<ByteView, AbortCode> domain_value(const EntryRef& entry) override;
    MutableBytes staging(const EntryRef& entry) override;
    AbortCode commit(const EntryRef& entry, std::size_t length, Instant now) override;

    /// Two memories of one size, taken when they are needed: a download gathers in the one while the other keeps the
    /// value.
    struct Domain {
        std::uint16_t index{0};
        std::uint8_t subindex{0};
        std::size_t size{0};
        std::vector<std::uint8_t> value;
        std::vector<std::uint8_t> staging;
        std::size_t length{0};
        bool holds_value{false};
    };
    Domain* domain(std::uint16_t index, std::uint8_t subindex);
    PdoMemory pdo_memory();

    DictionaryRows rows_;
    DictionaryTables tables_;
    std::vector<std::uint8_t> image_;
    ObjectDictionary objects_;
    ErrorTable errors_;
    std::vector<ReceivePdo> received_;
    std::vector<TransmitPdo> sent_;
    std::vector<PdoLine> received_lines_;
    std::vector<PdoLine> sent_lines_;
    Node node_;
    int communication_errors_{0};
    LssConfiguration stored_{};
    std::uint32_t bit_rate_{0};
    LssStore* store_{nullptr};
    LssError store_answer_{LssError::none};
    std::vector<Domain> domains_;
    AbortCode domain_refusal_{AbortCode::none};
};

}  // namespace canproof::host
