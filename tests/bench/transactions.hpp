// Whole transactions of a node, from the frame that is received to the frame that is handed over for sending. Each is
// set up once and can then be repeated.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"

namespace canproof::bench {

/// A node of the test dictionary with its bus side.
class TestNode {
  public:
    TestNode();

    // What is counted goes through these three: from the frame or event that the node gets to the frames that are taken
    // from its queue.

    /// Gives one frame to the node; its answers are taken from the queue and counted.
    [[gnu::noinline]] void receive(const Frame& frame);
    /// Lets a block upload send what is due.
    [[gnu::noinline]] void pump();
    /// The device gave an entry a new value. How many frames that caused.
    [[gnu::noinline]] std::size_t change(std::uint16_t index, std::uint8_t subindex);

    /// The same for `605#…` text; set-up only.
    void send(const std::string& frame);
    std::size_t take_answers();
    const Frame& last() const { return last_; }
    host::GenericDevice& device() { return *device_; }
    Instant now{};

  private:
    host::Memory memory_{16384};
    TransmitQueue queue_;
    std::unique_ptr<host::GenericDevice> device_;
    Frame last_{};
};

struct Transaction {
    std::string name;
    double limit;       ///< instructions that ours may take
    double best_other;  ///< instructions of the best of four other stacks, each on a small dictionary
    std::function<void(TestNode&)> prepare;
    std::function<void(TestNode&)> run;  ///< throws when the node did not do what it should
};

const std::vector<Transaction>& transactions();

}  // namespace canproof::bench
