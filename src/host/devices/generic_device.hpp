// A CANopen node from any description: the whole protocol layer, plain storage behind its objects.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/node.hpp"
#include "host/speccompiler/dictionary_rows.hpp"

namespace canproof::host {

/// The emergency codes that CiA 301 gives to the errors every node can notice (7.2.7.1, Table 26).
ErrorTable standard_errors();

class GenericDevice final : private Application {
  public:
    /// `part` describes the dictionary and what the node offers; it is copied into rows, not kept.
    GenericDevice(const Part& part, NonVolatileMemory& memory, TransmitQueue& queue);

    void power_on(std::uint8_t node_id, Instant now) { node_.power_on(node_id, now); }
    void receive(const Frame& frame, Instant now) { node_.receive(frame, now); }
    void advance(Instant now) { node_.advance(now); }
    Instant next_deadline() const { return node_.next_deadline(); }

    Node& node() { return node_; }
    ObjectDictionary& objects() { return objects_; }
    /// How often a communication error began or ended.
    int communication_errors() const { return communication_errors_; }

  private:
    AbortCode check_access(const EntryRef&) override { return AbortCode::none; }
    AbortCode before_write(const EntryRef&, ByteView) override { return AbortCode::none; }
    void after_write(const EntryRef&, Instant) override {}
    void put_factory_values(ParameterGroup) override {}
    void restart(Instant) override {}
    void booted(Instant) override {}
    void communication_failed(bool, Instant) override { ++communication_errors_; }

    DictionaryRows rows_;
    DictionaryTables tables_;
    std::vector<std::uint8_t> image_;
    ObjectDictionary objects_;
    ErrorTable errors_;
    Node node_;
    int communication_errors_{0};
};

}  // namespace canproof::host
