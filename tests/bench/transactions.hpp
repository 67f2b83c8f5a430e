// SPDX-License-Identifier: Apache-2.0
// CANopen transactions of a node, such as an SDO transfer or a PDO: from the received frame to the frame in the
// transmit queue. Each transaction is set up once and can then be repeated.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"
#include "tests/bench/server.hpp"

namespace canproof::bench {

/// A node with the object dictionary of test_dictionary.hpp and a transmit queue.
class TestNode final : public Server {
  public:
    TestNode();

    [[gnu::noinline]] void receive(const Frame& frame) override;
    [[gnu::noinline]] void pump() override;
    [[gnu::noinline]] std::size_t change(std::uint16_t index, std::uint8_t subindex) override;

    void receive_words(std::uint32_t identifier) override;
    void send_words(std::uint32_t identifier) override;

  private:
    void map_words(unsigned communication, std::uint32_t cob_id);
    std::size_t take_answers();

    host::Memory memory_{16384};
    TransmitQueue queue_;
    std::unique_ptr<host::GenericDevice> device_;
    Instant now_{};
};

/// Returns the floor (the minimal server of floor/floor.hpp) with the entries of the object dictionary of
/// test_dictionary.hpp.
std::unique_ptr<Server> make_floor();

struct Transaction {
    std::string name;
    double limit;        ///< instructions that a node may take with link-time optimisation
    double plain_limit;  ///< instructions that a node may take without link-time optimisation
    std::function<void(Server&)> prepare;
    std::function<void(Server&)> run;  ///< throws if the server gives a wrong result
};

const std::vector<Transaction>& transactions();

}  // namespace canproof::bench
