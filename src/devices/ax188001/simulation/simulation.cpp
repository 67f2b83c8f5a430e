// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/simulation/simulation.hpp"

#include "devices/ax188001/firmware/ax188001.hpp"
#include "devices/ax188001/simulation/thermocouple_plant.hpp"
#include "generated/ax188001/constants.hpp"
#include "host/sim/devices/simulation.hpp"

namespace canproof::ax188001 {

using namespace host;

namespace {

constexpr std::size_t memory_size = 1024;  // two banks of parameters, and the settings of LSS at the end

ax188001::FactoryData factory_data(const FactoryValues& values) {
    ax188001::FactoryData data;
    values.take("revision_number", data.revision);
    values.take("serial_number", data.serial_number);
    return data;
}

class Ax188001Simulation final
    : public Simulation<ax188001::Device, ax188001::Inputs, ax188001::Outputs, ax188001::FactoryData> {
  public:
    explicit Ax188001Simulation(const FactoryValues& factory) : Simulation{memory_size, factory_data(factory)} {}

    void set_node_id(NodeId node_id) override {
        namespace own = generated::ax188001;
        store_node_id(node_id, {own::shipped_node_id, own::shipped_bit_rate});
    }
    void power_on(Instant now) override {
        // The simulated wires get the sensor types of the stored parameters. A temporary second unit reads these types
        // from the same memory.
        TransmitQueue nowhere;
        ax188001::Device reader{memory_, nowhere, {}};
        reader.power_on(inputs_, now);
        plant_.drive(inputs_, types_of(reader));
        Simulation::power_on(now);
    }
    void receive(const Frame& frame, Instant now) override {
        Simulation::receive(frame, now);
        follow_plant(now);
    }
    bool set_input(const std::string& name, double value, Instant now) override {
        if (!put_input(name, value)) {
            return false;
        }
        plant_.stimulus(name);
        plant_.drive(inputs_, types_of(device_));
        device_.set_inputs(inputs_, now);
        return true;
    }

  private:
    static std::array<ax188001::SensorType, ax188001::channel_count> types_of(const ax188001::Device& device) {
        return {device.sensor_type(0), device.sensor_type(1)};
    }
    void follow_plant(Instant now) {
        if (plant_.drive(inputs_, types_of(device_))) {
            device_.set_inputs(inputs_, now);
        }
    }

    ThermocouplePlant plant_;
};

}  // namespace

std::unique_ptr<host::SimulatedDevice> make_simulation(const host::FactoryValues& factory) {
    return std::make_unique<Ax188001Simulation>(factory);
}

}  // namespace canproof::ax188001
