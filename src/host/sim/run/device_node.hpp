// SPDX-License-Identifier: Apache-2.0
// A simulated device as a node of a bus.
#pragma once

#include <memory>
#include <string>

#include "generated/canopen/index.hpp"
#include "host/sim/bus/bus.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

class DeviceNode final : public BusNode {
  public:
    DeviceNode(std::string name, std::unique_ptr<SimulatedDevice> device)
        : name_{std::move(name)}, device_{std::move(device)} {}

    /// Returns the device in order to change it. The call informs the bus and the session about a change. So the caller
    /// must request the reference again for each change.
    SimulatedDevice& device() {
        tell_change();
        return *device_;
    }
    const SimulatedDevice& device() const { return *device_; }

    void power_on(Instant now) {
        device_->power_on(now);
        refresh_filters();
        tell_change();
    }
    /// Sets an input. Returns false when the device has no input with this name.
    bool set_input(const std::string& name, double value, Instant now) {
        const bool found = device_->set_input(name, value, now);
        tell_change();
        return found;
    }

    const std::string& name() const override { return name_; }
    const Frame* next_frame() const override { return device_->queue().front(); }
    void take_frame() override {
        device_->queue().pop();
        tell_change();
    }
    void receive(const Frame& frame, Instant now) override {
        device_->receive(frame, now);
        if (may_configure(frame)) {
            refresh_filters();
        }
        tell_change();
    }
    /// Sets the input `can_state` of the device. Does nothing for a device without this input.
    void set_can_state(CanState state, Instant now) override {
        set_input("can_state", static_cast<double>(state), now);
    }
    void set_overrun(bool lost, Instant now) override { set_input("can_overrun", lost ? 1.0 : 0.0, now); }
    const std::vector<AcceptanceFilter>& filters() const override { return filters_; }
    std::uint32_t bit_rate() const override { return device_->bit_rate(); }
    bool tells_changes() const override { return true; }

  private:
    /// Returns whether a frame can change the filters of the node: NMT, LSS or SDO. Returns true for every frame if the
    /// device has more than one SDO server, because requests to the other servers can have any identifier.
    bool may_configure(const Frame& frame) const {
        const ObjectDictionary* objects = device_->objects();
        const bool sdo = frame.id >= first_sdo_request && frame.id <= last_sdo_request;
        return sdo || frame.id == 0U || frame.id == generated::canopen::lss_request_cob_id ||
               (objects != nullptr && objects->has(second_sdo_server, 0U));
    }

    void refresh_filters() {
        const ObjectDictionary* objects = device_->objects();
        filters_ = objects == nullptr ? accept_everything() : acceptance_filters(*objects, device_->node_id());
    }

    static constexpr std::uint32_t first_sdo_request = 0x601U;
    static constexpr std::uint32_t last_sdo_request = 0x67FU;
    static constexpr std::uint16_t second_sdo_server = generated::canopen::index::sdo_server_parameter + 1U;

    std::string name_;
    std::unique_ptr<SimulatedDevice> device_;
    std::vector<AcceptanceFilter> filters_{accept_everything()};
};

}  // namespace canproof::host
