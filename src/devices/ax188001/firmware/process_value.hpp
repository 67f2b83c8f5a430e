// From field values, which are physical, to process values, which are sent (AX188001, 1.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canproof::ax188001 {

/// process value = field value · factor + offset
struct Scaling {
    double factor{1.0};
    double offset{0.0};
};

/// The nearest whole number, halves away from zero, held at the ends of 16 bits.
std::int16_t process_value(double field_value, const Scaling& scaling) noexcept;

/// Values that mean something other than a measurement.
struct ReservedValues {
    std::int16_t disabled{0};
    std::int16_t open{0};
};

/// As process_value, but a measurement that falls on a reserved value is moved up by one.
std::int16_t measured_process_value(double field_value, const Scaling& scaling,
                                    const ReservedValues& reserved) noexcept;

struct Measurement {
    double value{0.0};
    bool valid{false};
};

/// Mean of the valid ones; not valid when none is.
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
