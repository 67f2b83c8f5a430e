// SPDX-License-Identifier: Apache-2.0
// Compares the firmware's conversion between thermocouple voltage and temperature, for doubles of any bit pattern, with
// the reference functions in long double. Input: records of ten bytes: the type, the function, and eight bytes of a
// double.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "devices/ax188001/simulation/exact_reference.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/require.hpp"
#include "generated/ax188001/requirements.hpp"

namespace {

using namespace canproof;
using namespace canproof::ax188001;
using fuzz::require;
using generated::ax188001::SensorType;

constexpr std::size_t record_size = 10;
constexpr SensorType types[]{SensorType::j, SensorType::k, SensorType::n, SensorType::r,
                             SensorType::s, SensorType::t, SensorType::e, SensorType::b};

/// Checks that any voltage gives a temperature within the range of the thermocouple type. For a voltage within the
/// range, also checks that the reference function returns this voltage for the temperature.
void check_voltage(SensorType type, double mv) {
    const ThermocoupleCurve& curve = thermocouple_curve(type);
    const double celsius = exact_celsius(curve, mv);
    require(celsius >= curve.lowest_c() && celsius <= curve.highest_c());
    if (mv > reference_mv(curve, curve.lowest_c()) && mv < reference_mv(curve, curve.highest_c())) {
        const double slope = reference_slope(curve, celsius);
        const double excess =
            static_cast<double>(ax188001::reference_mv_exactly(type, static_cast<long double>(celsius))) - mv;
        // At the lower end of the curve of type B the slope is 0, so the voltage itself must match.
        require(std::fabs(excess) < std::fmax(0.02 * slope, 1e-9));
    }
}

/// Converts a temperature of the type's range into its voltage and back. Checks that the result is the same temperature
/// within a tolerance.
void check_temperature(SensorType type, double fraction) {
    const ThermocoupleCurve& curve = thermocouple_curve(type);
    const double part = std::fabs(std::fmod(fraction, 1.0));
    if (!(part >= 0.0)) {
        return;  // NaN or infinity
    }
    const double celsius = curve.lowest_c() + (curve.highest_c() - curve.lowest_c()) * part;
    const double mv = static_cast<double>(ax188001::reference_mv_exactly(type, static_cast<long double>(celsius)));
    const double tolerance = reference_slope(curve, celsius) < 2e-5 ? 0.5 : 0.02;
    require(std::fabs(exact_celsius(curve, mv) - celsius) < tolerance);
}

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::TCS_CONV_002)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (; size >= record_size; data += record_size, size -= record_size) {
        const SensorType type = types[data[0] % std::size(types)];
        double number = 0.0;
        std::memcpy(&number, data + 2, sizeof number);
        if (data[1] % 2 == 0) {
            check_voltage(type, number);
        } else {
            check_temperature(type, number);
        }
    }
    return 0;
}
