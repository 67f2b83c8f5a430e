// SPDX-License-Identifier: Apache-2.0
// Converts field values (physical units) to process values (sent on the bus) (AX188001, 1.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::ax188001 {

/// The scaling: process value = field value · factor + offset.
struct Scaling {
    double factor{1.0};
    double offset{0.0};
};

/// Returns the process value: rounded to nearest, halves away from zero, and saturated to INTEGER16. NaN gives -32768.
std::int16_t process_value(double field_value, const Scaling& scaling) noexcept;

/// Process values that stand for a disabled channel or an open circuit, not for a measurement.
struct ReservedValues {
    std::int16_t disabled{0};
    std::int16_t open{0};
};

/// Returns the process value of a measurement. A result that equals a reserved value is increased by one; therefore the
/// two reserved values must not be neighbours.
std::int16_t measured_process_value(double field_value, const Scaling& scaling,
                                    const ReservedValues& reserved) noexcept;

struct Measurement {
    double value{0.0};
    bool valid{false};
};

/// Returns the mean of the valid measurements; not valid when there is none.
template <std::size_t Count>
Measurement average(const std::array<Measurement, Count>& all) noexcept {
    double sum{0.0};
    std::size_t count{0U};
    for (const Measurement& one : all) {
        if (one.valid) {
            sum += one.value;
            ++count;
        }
    }
    return (count == 0U) ? Measurement{} : Measurement{sum / static_cast<double>(count), true};
}

}  // namespace canproof::ax188001
