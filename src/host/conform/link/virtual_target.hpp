// SPDX-License-Identifier: Apache-2.0
// A simulated slave on its own bus in virtual time. The same steps always give the same frames at the same times.
#pragma once

#include <memory>
#include <string>

#include "host/conform/link/target.hpp"
#include "host/conform/link/tester_node.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/run/device_node.hpp"

namespace canproof::host::conform {

class VirtualTarget final : public Target {
  public:
    static constexpr std::uint32_t usual_bit_rate = 125000U;

    /// Makes the target. `device` is the slave, which is switched on at time 0. `bit_rate`, in bit/s, applies while the
    /// slave reports no bit rate. `name` appears in the report.
    VirtualTarget(std::unique_ptr<SimulatedDevice> device, std::uint8_t node_id,
                  std::uint32_t bit_rate = usual_bit_rate, std::string name = "virtual time");

    Instant now() const override { return now_; }
    void send(const Frame& frame) override;
    std::size_t waiting() const override { return tester_.waiting(); }
    /// Lets time pass as Target::advance() does. Throws StuckDevice for a slave that does not process its deadlines.
    void advance(Instant until) override;
    PowerSwitch power_switch() const override { return PowerSwitch::program; }
    void power(bool on) override;
    bool follows_bit_rate() const override { return true; }
    std::uint32_t bit_rate() const override { return bus_.report(now_).bit_rate; }
    const std::string& name() const override { return name_; }
    bool is_repeatable() const override { return true; }
    BusReport report() const override { return bus_.report(now_); }

    SimulatedDevice& device() { return slave_.device(); }

  private:
    /// The slave with its power switch. While it is off, it neither receives nor sends.
    class Slave final : public BusNode {
      public:
        explicit Slave(std::unique_ptr<SimulatedDevice> device) : node_{"slave", std::move(device)} {}

        SimulatedDevice& device() { return node_.device(); }
        const SimulatedDevice& device() const { return node_.device(); }
        bool is_on() const { return on_; }
        void power(bool on, Instant now);

        const std::string& name() const override { return node_.name(); }
        const Frame* next_frame() const override { return on_ ? node_.next_frame() : nullptr; }
        void take_frame() override { node_.take_frame(); }
        void receive(const Frame& frame, Instant now) override;
        void set_can_state(CanState state, Instant now) override;
        void set_overrun(bool lost, Instant now) override;
        /// Sets no acceptance filter, so that the slave receives every frame, as on a real bus. The cases check how the
        /// slave handles them.
        const std::vector<AcceptanceFilter>& filters() const override { return accept_everything(); }
        std::uint32_t bit_rate() const override { return node_.bit_rate(); }

      private:
        DeviceNode node_;
        bool on_{false};
    };

    void step(Instant at);
    Instant next_deadline() const;

    std::string name_;
    Slave slave_;
    TesterNode tester_;
    ArbitratedBus bus_;
    Instant now_{};
    bool frame_seen_{false};
};

}  // namespace canproof::host::conform
