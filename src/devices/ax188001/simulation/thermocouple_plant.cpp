// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/simulation/thermocouple_plant.hpp"

#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "generated/ax188001/tables.hpp"

namespace canproof::ax188001 {

namespace {

ax188001::SensorType wire_type(std::uint8_t number, ax188001::SensorType configured) {
    const auto type = static_cast<ax188001::SensorType>(number);
    const bool known = generated::ax188001::thermocouple_type::find(type) != nullptr;
    return known ? type : configured;
}

}  // namespace

void ThermocouplePlant::stimulus(const std::string& name) {
    for (std::size_t i = 0; i < by_temperature_.size(); ++i) {
        const std::string channel = "tc" + std::to_string(i + 1);
        if (name == channel + "_celsius" || name == channel + "_wire") {
            by_temperature_[i] = true;
        } else if (name == channel + "_microvolts") {
            by_temperature_[i] = false;
        }
    }
}

bool ThermocouplePlant::drive(ax188001::Inputs& inputs,
                              const std::array<ax188001::SensorType, ax188001::channel_count>& configured) const {
    bool changed = false;
    for (std::size_t i = 0; i < by_temperature_.size(); ++i) {
        if (!by_temperature_[i]) {
            continue;
        }
        const ThermocoupleCurve& curve = thermocouple_curve(wire_type(inputs.tc_wire[i], configured[i]));
        const double mv = reference_mv(curve, static_cast<double>(inputs.tc_celsius[i])) -
                          reference_mv(curve, static_cast<double>(inputs.cold_junction));
        const auto microvolts = static_cast<float>(mv * 1000.0);
        changed = changed || microvolts != inputs.tc_microvolts[i];
        inputs.tc_microvolts[i] = microvolts;
    }
    return changed;
}

}  // namespace canproof::ax188001
