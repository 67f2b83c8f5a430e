// SPDX-License-Identifier: Apache-2.0
// A device of the catalogue whose firmware runs on the emulated microcontroller. Each call passes its time to the
// image, and ends before the next call begins.
// A twin, the same device in this program, simulates the physical world and receives every call as well. When the two
// behave differently, they were built from different sources or one of the compilers is wrong.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/image/image_calls.hpp"

namespace canproof::host {

class ImageDevice final : public SimulatedDevice {
  public:
    /// Makes the device. `link` must have read the greeting of the image. Throws ImageFailed when the signals of the
    /// image differ from those of the simulated twin.
    ImageDevice(std::unique_ptr<ImageLink> link, const ImageGreeting& greeting, std::unique_ptr<SimulatedDevice> twin);

    void set_node_id(NodeId node_id) override;
    bool set_coding_switches(std::uint8_t value) override { return twin_->set_coding_switches(value); }
    // The following five functions throw ImageFailed when the link fails. The first four also throw it when the image
    // and its simulated twin differ.
    void power_on(Instant now) override;
    void receive(const Frame& frame, Instant now) override;
    void advance(Instant now) override;
    bool set_input(const std::string& name, double value, Instant now) override;
    Instant next_deadline() const override;

    std::vector<double> inputs() const override { return twin_->inputs(); }
    const std::vector<std::string>& input_names() const override { return twin_->input_names(); }
    std::vector<double> outputs() const override { return calls_->state().outputs; }
    const std::vector<std::string>& output_names() const override { return twin_->output_names(); }
    std::uint8_t node_id() const override;
    NmtState state() const override { return calls_->state().nmt; }
    std::uint32_t bit_rate() const override { return calls_->state().bit_rate; }

  private:
    /// Removes as many frames from the queue of the simulated twin as have left the image's queue. Removes all frames
    /// when the image has its own clock.
    void follow_queue() const;
    /// Sends the inputs of the simulated twin to the image if a call has changed them. `before` are the inputs before
    /// the call.
    void follow_inputs(const std::vector<double>& before, Instant now);
    /// Throws ImageFailed when the states of the image and its simulated twin differ. An image with its own clock is
    /// not compared, because it does everything a little later than the twin.
    void compare(Instant now) const;
    /// Returns a description of the first difference between the image and its simulated twin; empty when there is
    /// none.
    std::string difference() const;

    std::unique_ptr<SimulatedDevice> twin_;
    std::unique_ptr<ImageCalls> calls_;
    bool has_own_clock_;
};

}  // namespace canproof::host
