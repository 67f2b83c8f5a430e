// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/simulation/sensor_keys.hpp"

#include "devices/ax060805/simulation/angle_range.hpp"
#include "devices/ax060805/simulation/sensor_errors.hpp"

namespace canproof::ax060805 {

using namespace host;

namespace {

FactoryKey error_key(const char* name, double greatest, const char* unit, const char* text) {
    FactoryKey key;
    key.name = name;
    key.type = "REAL32";
    key.unit = unit;
    key.minimum = -greatest;
    key.maximum = greatest;
    key.text = text;
    return key;
}

}  // namespace

std::vector<FactoryKey> sensor_keys(const std::string& part_number) {
    const std::uint16_t model = model_of(part_number);
    std::vector<FactoryKey> keys;
    FactoryKey range;
    range.name = angle_range_key;
    range.type = "VISIBLE_STRING";
    range.unit = "deg";
    for (const AngleRange& one : angle_ranges) {
        range.words.emplace_back(one.word);
    }
    range.text = "angle configuration, Table 8";
    keys.push_back(range);
    const SensorErrors greatest = greatest_errors(model);
    keys.push_back(
        error_key("sensor_initial_error", greatest.initial, "deg", "error of the angles at 25 degC, Table 62"));
    keys.push_back(error_key("sensor_drift", greatest.drift, "deg", "temperature drift, Table 62"));
    keys.push_back(error_key("sensor_nonlinearity", greatest.nonlinearity, "%", "non-linearity, Table 62"));
    keys.push_back(error_key("sensor_cross_axis", greatest.cross_axis, "%", "cross-axis sensitivity, Table 62"));
    return keys;
}

}  // namespace canproof::ax060805
