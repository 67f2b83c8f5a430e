// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/simulation/simulation.hpp"

#include "devices/ax060805/firmware/ax060805.hpp"
#include "devices/ax060805/simulation/angle_range.hpp"
#include "devices/ax060805/simulation/inclinometer_plant.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"
#include "host/sim/devices/simulation.hpp"

namespace canproof::ax060805 {

using namespace host;

namespace {

namespace own = generated::ax060805;

constexpr std::size_t memory_size = 4096;  // bytes for two banks of parameters, and for the settings of LSS at the end

ax060805::FactoryData factory_data(const FactoryValues& values) {
    ax060805::FactoryData data;
    values.take("revision_number", data.revision);
    values.take("serial_number", data.serial_number);
    values.take("verify_configuration_1", data.made_on);
    values.take("verify_configuration_2", data.made_at);
    values.take("calibrated_pitch_angle_data", data.calibration.pitch);
    values.take("calibrated_roll_angle_data", data.calibration.roll);
    const auto range = values.text(angle_range_key);
    for (const AngleRange& one : angle_ranges) {
        data.range = range == one.word ? one.range : data.range;
    }
    return data;
}

SensorErrors sensor_errors(const FactoryValues& values) {
    static_assert(implements<req::INC_PLANT_010>);
    SensorErrors errors;
    values.take("sensor_initial_error", errors.initial);
    values.take("sensor_drift", errors.drift);
    values.take("sensor_nonlinearity", errors.nonlinearity);
    values.take("sensor_cross_axis", errors.cross_axis);
    return errors;
}

class Ax060805Simulation final
    : public Simulation<ax060805::Device, ax060805::Inputs, ax060805::Outputs, ax060805::FactoryData> {
  public:
    static_assert(implements<req::INC_PLANT_005>);
    explicit Ax060805Simulation(const FactoryValues& factory)
        : Simulation{memory_size, factory_data(factory)}, plant_{sensor_errors(factory)} {
        inputs_.noise_of = model_of(factory.part_number());
    }

    void set_node_id(NodeId node_id) override { store_node_id(node_id, {own::shipped_node_id, own::shipped_bit_rate}); }
    void power_on(Instant now) override {
        plant_.add_noise(inputs_);
        Simulation::power_on(now);
    }
    void advance(Instant now) override {
        Simulation::advance(now);
        if (plant_.is_noisy(inputs_) && next_noise_ <= now) {
            next_noise_ = now + microseconds(own::sample_period_us);
            plant_.add_noise(inputs_);
            device_.set_inputs(inputs_, now);
        }
    }
    bool set_input(const std::string& name, double value, Instant now) override {
        if (!put_input(name, value)) {
            return false;
        }
        plant_.stimulus(name, inputs_);
        device_.set_inputs(inputs_, now);
        return true;
    }

  private:
    InclinometerPlant plant_;
    Instant next_noise_{};
};

}  // namespace

std::unique_ptr<host::SimulatedDevice> make_simulation(const host::FactoryValues& factory) {
    return std::make_unique<Ax060805Simulation>(factory);
}

}  // namespace canproof::ax060805
