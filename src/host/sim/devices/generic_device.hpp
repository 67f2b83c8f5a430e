// SPDX-License-Identifier: Apache-2.0
// A CANopen node made from any device description: the complete protocol layer, with plain memory for its objects.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/node.hpp"
#include "host/codegen/dictionary_rows.hpp"

namespace canproof::host {

/// Returns the emergency codes and error register bits of the errors that every node can detect (CiA 301, 7.2.7.1,
/// Table 26).
ErrorTable standard_errors();

/// The dictionary of a generic device and the profile of its node.
struct GenericDescription {
    DictionaryRows rows;
    NodeProfile profile;
};

/// Returns the description of a device in the requirements register. If the device has LSS, the LSS profile is
/// standard_lss().
GenericDescription describe(const Part& part);
/// Returns an LSS profile with the bit rates of CiA 305. With this profile, leaving the LSS configuration state does
/// not reset the communication; only the NMT master resets the node.
LssProfile standard_lss();

class GenericDevice final : private Application {
  public:
    GenericDevice(const Part& part, NonVolatileMemory& memory, TransmitQueue& queue);
    GenericDevice(GenericDescription description, NonVolatileMemory& memory, TransmitQueue& queue);

    void power_on(std::uint8_t node_id, Instant now) { power_on(LssConfiguration{node_id}, now); }
    /// Starts the device with a stored LSS configuration, which also contains the bit rate. `can_state` and `overrun`
    /// are the inputs from the controller, as in Node::set_controller().
    void power_on(const LssConfiguration& stored, Instant now, std::uint8_t can_state = 0, bool overrun = false);
    void receive(const Frame& frame, Instant now) { node_.receive(frame, now); }
    void advance(Instant now) { node_.advance(now); }
    Instant next_deadline() const { return node_.next_deadline(); }

    Node& node() { return node_; }
    const Node& node() const { return node_; }
    ObjectDictionary& objects() { return objects_; }
    const ObjectDictionary& objects() const { return objects_; }
    /// Gives a DOMAIN entry memory of `size` bytes, which is allocated at its first use. The entry has no content yet.
    void lend(std::uint16_t index, std::uint8_t subindex, std::size_t size);
    /// Allocates the memory of every DOMAIN. After that, the device allocates nothing.
    void take_domain_memory();
    /// Returns the content of a DOMAIN entry; empty when it has none.
    ByteView held(std::uint16_t index, std::uint8_t subindex) const;
    /// Sets the content of a DOMAIN entry, as a download does.
    void fill(std::uint16_t index, std::uint8_t subindex, const std::vector<std::uint8_t>& bytes);
    /// Removes the content of a DOMAIN entry.
    void empty(std::uint16_t index, std::uint8_t subindex);
    /// Sets the abort code with which the device refuses downloads to DOMAIN entries. AbortCode::none accepts every
    /// download.
    void refuse_domains_with(AbortCode code) { domain_refusal_ = code; }

    /// Returns the bit rate in bit/s that LSS set last.
    std::uint32_t bit_rate() const { return bit_rate_; }
    /// Returns the configuration that LSS stored last.
    const LssConfiguration& stored() const { return stored_; }
    /// Sets the store for LSS configurations, which must outlive the device.
    void store_in(LssStore& store) { store_ = &store; }
    /// Sets the answer to the LSS command `store configuration` for a device without a store. The device keeps the
    /// configuration only if the answer is LssError::none.
    void answer_store_with(LssError error) { store_answer_ = error; }

    /// Returns how often a communication error has begun or ended.
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

    /// The two memories of a DOMAIN, which have the same size. A download fills one while the other contains the
    /// present value. They are allocated when they are first used.
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
