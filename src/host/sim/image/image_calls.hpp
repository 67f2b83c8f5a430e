// SPDX-License-Identifier: Apache-2.0
// Calls the firmware of a device that runs as an image on the microcontroller. The host holds the parameter memory
// of the device, which the image reads and writes during a call. After the call, the host also holds the frames that
// wait to be sent.
#pragma once

#include <memory>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/nmt.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "host/sim/devices/memory.hpp"
#include "host/sim/image/image_link.hpp"

namespace canproof::host {

/// The state of a device after a call.
struct DeviceState {
    Instant deadline{never};
    std::uint8_t node_id{0};
    NmtState nmt{NmtState::initialising};
    std::uint32_t bit_rate{0};  ///< bit rate in bit/s
    std::vector<double> outputs;
};

class ImageCalls {
  public:
    /// Prepares the calls. `link` must have read the greeting, the image's first message. `queue` receives the frames
    /// that the image sends; a frame that is removed from it counts as sent.
    ImageCalls(std::unique_ptr<ImageLink> link, std::size_t outputs, TransmitQueue& queue, Memory& memory);

    // The following calls throw ImageFailed when the link fails. `inputs` must be in the order of the requirements
    // register.
    void power_on(const std::vector<double>& inputs, Instant now);
    void set_inputs(const std::vector<double>& inputs, Instant now);
    void receive(const Frame& frame, Instant now);
    void advance(Instant now);
    /// Reports to the image how many frames have been sent since the last call, and gets the new state.
    void look();

    /// Returns the state after the last call.
    const DeviceState& state() const { return state_; }
    /// Returns the number of frames that were sent since the last call.
    std::size_t sent() const { return waiting_ - queue_.size(); }
    /// Returns whether the memory has stored the image's last commit. Returns true before the first commit.
    bool has_committed() const { return committed_; }
    const std::string& name() const { return link_->name(); }

  private:
    bridge::Message command(bridge::Kind kind) const;
    bridge::Message command(bridge::Kind kind, Instant now) const;
    bridge::Message command(bridge::Kind kind, Instant now, const std::vector<double>& inputs) const;
    void call(bridge::Message command);
    bridge::Message access(bridge::Message& wanted);
    void take_state(bridge::Message& message);

    std::unique_ptr<ImageLink> link_;
    TransmitQueue& queue_;
    Memory& memory_;
    DeviceState state_;
    std::size_t waiting_{0};  ///< number of frames in the queue after the last call
    bool committed_{true};
};

}  // namespace canproof::host
