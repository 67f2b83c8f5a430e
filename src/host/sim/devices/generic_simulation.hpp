// SPDX-License-Identifier: Apache-2.0
// The simulation of a generic device: the protocol layer with a dictionary that was read at run time. The LSS
// configuration and the parameters are stored in the same memory.
#pragma once

#include "firmware/canopen/lss_store.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

class GenericSimulation final : public SimulatedDevice {
  public:
    /// Size of each DOMAIN entry in bytes, and limit for the sum of all these sizes. With many entries, each entry gets
    /// less.
    static constexpr std::size_t domain_size = 65536;
    static constexpr std::size_t all_domains_size = std::size_t{16} << 20U;

    explicit GenericSimulation(Part part);

    const Part& part() const { return part_; }
    /// Returns the device, so that a test can change its behaviour.
    GenericDevice& device() { return device_; }

    void set_node_id(NodeId node_id) override;
    void power_on(Instant now) override;
    void receive(const Frame& frame, Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override { return device_.next_deadline(); }
    /// Sets the input `can_state` or `can_overrun`, which the devices of the catalogue have as well. Other inputs do
    /// not exist: a user changes the objects of the device by SDO or PDO.
    bool set_input(const std::string& name, double value, Instant now) override;
    std::vector<double> inputs() const override { return {static_cast<double>(can_state_), overrun_ ? 1.0 : 0.0}; }
    const std::vector<std::string>& input_names() const override;
    std::vector<double> outputs() const override { return {}; }
    const std::vector<std::string>& output_names() const override;
    std::uint8_t node_id() const override { return device_.node().node_id(); }
    NmtState state() const override { return device_.node().state(); }
    std::uint32_t bit_rate() const override { return device_.bit_rate(); }
    const ObjectDictionary* objects() const override { return &device_.objects(); }

  private:
    Part part_;
    GenericDevice device_;
    LssStore store_;
    LssConfiguration shipped_;
    std::uint8_t can_state_{0};
    bool overrun_{false};
};

}  // namespace canproof::host
