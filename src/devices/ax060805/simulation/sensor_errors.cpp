// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/simulation/sensor_errors.hpp"

#include <fmt/format.h>

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"
#include "generated/ax060805/tables.hpp"

namespace canproof::ax060805 {

namespace {

namespace own = generated::ax060805;

constexpr double pi = 3.14159265358979323846;

/// Returns the number in double precision as the requirements register contains it: 0.7, not 0.699999988.
double as_written(float value) {
    return std::stod(fmt::format("{}", value));
}

/// Returns the shape of the non-linearity: 0 at 0 g and from ±1 g outwards; 1 and -1 at the extremes between them,
/// which lie at ±1 / sqrt(3) g.
static_assert(implements<req::INC_PLANT_009>);
double bow(double g) {
    return std::fabs(g) < 1.0 ? 1.5 * std::sqrt(3.0) * (g - g * g * g) : 0.0;
}

}  // namespace

std::uint16_t model_of(const std::string& part_number) {
    const auto digits = part_number.find_first_of("123456789");
    return digits == std::string::npos ? std::uint16_t{0}
                                       : static_cast<std::uint16_t>(std::stoul(part_number.substr(digits)));
}

static_assert(implements<req::INC_T62> && implements<req::INC_K_INITIAL_ACCURACY>);
static_assert(implements<req::INC_PLANT_011>);
SensorErrors greatest_errors(std::uint16_t model) {
    const auto* const row = own::sensor_accuracy::find(model);
    if (row == nullptr) {
        return {};
    }
    return {as_written(own::initial_accuracy), as_written(row->drift), as_written(row->nonlinearity),
            as_written(row->cross_axis)};
}

static_assert(implements<req::INC_PLANT_004> && implements<req::INC_K_DRIFT_REFERENCE> &&
              implements<req::INC_K_LOWEST_AMBIENT>);
Vector3 with_errors(const Vector3& felt, const SensorErrors& errors, double temperature) {
    const auto reference = static_cast<double>(own::drift_reference);
    const double share = (temperature - reference) / (reference - static_cast<double>(own::lowest_ambient));
    // With this offset on X and on Y, no vector of 1 g turns by more than the error angle. A third offset on Z could
    // turn a vector further.
    static_assert(implements<req::INC_PLANT_008> && implements<req::INC_PLANT_012>);
    const double offset = std::sin((errors.initial + errors.drift * share) * pi / 180.0) / std::sqrt(2.0);
    const auto axis = [&](float own_axis, float next, double shift) {
        const auto g = static_cast<double>(own_axis);
        return static_cast<float>(g + shift + errors.nonlinearity / 100.0 * bow(g) +
                                  errors.cross_axis / 100.0 * static_cast<double>(next));
    };
    return {axis(felt.x, felt.y, offset), axis(felt.y, felt.z, offset), axis(felt.z, felt.x, 0.0)};
}

}  // namespace canproof::ax060805
