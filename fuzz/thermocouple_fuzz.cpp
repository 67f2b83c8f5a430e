// Thermocouple arithmetic on any bit pattern, against the reference functions in long double.
// Input: records of ten bytes: the type, what is asked, and eight bytes of a double.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "firmware/blocks/thermocouple_curves.hpp"
#include "generated/ax188001/requirements.hpp"
#include "support/claims.hpp"
#include "support/record_mutator.hpp"
#include "support/require.hpp"

namespace {

using namespace canproof;
using fuzz::require;
using generated::ax188001::SensorType;

constexpr std::size_t record_size = 10;
constexpr SensorType types[]{SensorType::j, SensorType::k, SensorType::n, SensorType::r,
                             SensorType::s, SensorType::t, SensorType::e, SensorType::b};

long double exact_mv(const ThermocoupleCurve& curve, long double celsius) {
    std::size_t at = 0;
    while (at + 1 < curve.reference_count && celsius >= static_cast<long double>(curve.reference[at].to_c)) {
        ++at;
    }
    const ReferencePiece& piece = curve.reference[at];
    long double sum = 0.0L;
    for (auto c = piece.coefficients.rbegin(); c != piece.coefficients.rend(); ++c) {
        sum = sum * celsius + static_cast<long double>(*c);
    }
    const auto& term = piece.exponential;
    const long double distance = celsius - static_cast<long double>(term.a2_c);
    return sum + static_cast<long double>(term.a0_mv) *
                     std::exp(static_cast<long double>(term.a1_per_c2) * distance * distance);
}

/// A voltage of any bits gives a temperature of the type's range, and within the range that voltage's own.
void check_voltage(const ThermocoupleCurve& curve, double mv) {
    const double celsius = exact_celsius(curve, mv);
    require(celsius >= curve.lowest_c && celsius <= curve.highest_c);
    if (mv > reference_mv(curve, curve.lowest_c) && mv < reference_mv(curve, curve.highest_c)) {
        const double slope = reference_slope(curve, celsius);
        const double excess = static_cast<double>(exact_mv(curve, static_cast<long double>(celsius))) - mv;
        // At the foot of type B's branch the slope vanishes: there the voltage itself must fit.
        require(std::fabs(excess) < std::fmax(0.02 * slope, 1e-9));
    }
}

/// A temperature in the range is found again from its voltage.
void check_temperature(const ThermocoupleCurve& curve, double fraction) {
    const double part = std::fabs(std::fmod(fraction, 1.0));
    if (!(part >= 0.0)) {
        return;  // no number
    }
    const double celsius = curve.lowest_c + (curve.highest_c - curve.lowest_c) * part;
    const double mv = static_cast<double>(exact_mv(curve, static_cast<long double>(celsius)));
    const double tolerance = reference_slope(curve, celsius) < 2e-5 ? 0.5 : 0.02;
    require(std::fabs(exact_celsius(curve, mv) - celsius) < tolerance);
}

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::TCS_CONV_002)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (; size >= record_size; data += record_size, size -= record_size) {
        const ThermocoupleCurve& curve = thermocouple_curve(types[data[0] % std::size(types)]);
        double number = 0.0;
        std::memcpy(&number, data + 2, sizeof number);
        if (data[1] % 2 == 0) {
            check_voltage(curve, number);
        } else {
            check_temperature(curve, number);
        }
    }
    return 0;
}
