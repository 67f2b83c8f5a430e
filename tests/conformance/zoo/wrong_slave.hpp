// SPDX-License-Identifier: Apache-2.0
// The conformance slave with one deliberate fault. A fault can change the frames that the slave receives, the frames
// that it sends, and its dictionary.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "host/sim/devices/generic_simulation.hpp"
#include "tests/conformance/zoo/fault.hpp"

namespace canproof::test::zoo {

/// A slave as node 5. Without a distortion it behaves correctly.
class WrongSlave final : public host::SimulatedDevice {
  public:
    explicit WrongSlave(Distortion distortion = {});

    void set_node_id(host::NodeId node_id) override { inner_->set_node_id(node_id); }
    void power_on(Instant now) override;
    void receive(const Frame& frame, Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override;
    bool set_input(const std::string& name, double value, Instant now) override;
    std::vector<double> inputs() const override { return inner_->inputs(); }
    const std::vector<std::string>& input_names() const override { return inner_->input_names(); }
    std::vector<double> outputs() const override { return inner_->outputs(); }
    const std::vector<std::string>& output_names() const override { return inner_->output_names(); }
    std::uint8_t node_id() const override { return inner_->node_id(); }
    NmtState state() const override { return inner_->state(); }
    std::uint32_t bit_rate() const override { return inner_->bit_rate(); }
    const ObjectDictionary* objects() const override { return inner_->objects(); }

    // The hooks of faults call the following functions.

    /// Gives a received frame to the correct slave.
    void pass(const Frame& frame) { inner_->receive(frame, now_); }
    /// Sends a frame.
    void say(const Frame& frame);
    /// Sends a frame at `when`, which is later than now.
    void say_at(Instant when, const Frame& frame) { later_.emplace(when.us, frame); }
    /// Gives an SDO request to the correct slave without any frame on the bus. Returns the answer of the correct slave.
    Frame ask(const Frame& request);
    /// Writes `size` (1 to 4) bytes of `value` by an SDO request without frames on the bus.
    void write(std::uint16_t index, std::uint8_t subindex, std::size_t size, std::uint32_t value);

    Instant now() const { return now_; }
    /// Returns the dictionary of the correct slave. No service is notified when a hook changes a value in it.
    ObjectDictionary& dictionary() { return inner_->device().objects(); }
    /// Returns whether the frame that is being sent is a segment of a block upload.
    bool says_segment() const { return says_segment_; }

    std::map<std::uint32_t, std::uint32_t> notes;  ///< state of the hooks of a fault; each hook chooses its keys
    std::vector<std::uint8_t> bytes;               ///< bytes of a transfer, stored by a hook

  private:
    static constexpr std::size_t most_waiting = 8;  ///< most frames in queue_; further frames wait in the correct slave

    bool has_room() const { return queue_.size() < most_waiting; }
    void hear(const Frame& frame);
    void follow_request(const Frame& frame);
    void follow_answer(const Frame& frame);
    void move_frames();
    void send_late_ones();

    Distortion distortion_;
    std::unique_ptr<host::GenericSimulation> inner_;  ///< the correct slave; a fault may change its dictionary
    Instant now_{};
    std::multimap<std::uint64_t, Frame> later_;
    std::uint8_t next_segment_{0};  ///< number of the next segment of a block upload; 0: no block upload
    bool says_segment_{false};
};

}  // namespace canproof::test::zoo
