// SPDX-License-Identifier: Apache-2.0
// Naive reading of one channel of the AX188001 (manual, 1.1, 1.3, appendix A). It models the converter with its gains
// and its filter, and finds the temperature for a voltage by bisection. Shares no code with the firmware.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "tests/devices/ax188001/its90.hpp"

namespace canproof::naive_tcs {

/// A thermocouple type of Table 1, with the range of voltages that appendix A prints for this type.
struct Sensor {
    const test::Its90Type* curve;
    double lowest_uv;
    double highest_uv;
    double lowest_c;
};

inline Sensor sensor(unsigned type) {
    struct Range {
        unsigned type;
        double lowest_uv;
        double highest_uv;
    };
    static constexpr std::array<Range, 8> ranges{{{1, -8095, 69553},
                                                  {2, -6458, 54886},
                                                  {4, -4345, 47513},
                                                  {5, -226, 21101},
                                                  {6, -236, 18693},
                                                  {7, -6258, 20872},
                                                  {9, -9835, 76373},
                                                  {10, 0, 13820}}};
    constexpr double b_turns_at_c = 21.0203;  // the voltage of type B falls up to this temperature and rises above it
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (ranges[i].type == type) {
            const test::Its90Type& curve = test::its90_types()[i];
            const double lowest = curve.letter == 'B' ? b_turns_at_c : static_cast<double>(curve.lowest());
            return {&curve, ranges[i].lowest_uv, ranges[i].highest_uv, lowest};
        }
    }
    return {&test::its90_types()[0], 0, 0, 0};
}

/// Returns the thermocouple voltage in uV of a junction at `celsius`, with the cold junction at 0 degC.
inline double uv_of(unsigned type, double celsius) {
    return static_cast<double>(sensor(type).curve->mv(static_cast<long double>(celsius))) * 1000.0;
}

/// Returns the temperature for a voltage, clamped to the range of the thermocouple type.
inline double celsius_of(unsigned type, double uv) {
    const Sensor wanted = sensor(type);
    double low = wanted.lowest_c;
    double high = static_cast<double>(wanted.curve->highest());
    if (uv <= uv_of(type, low)) {
        return low;
    }
    if (uv >= uv_of(type, high)) {
        return high;
    }
    while (high - low > 1e-9) {
        const double middle = (low + high) / 2.0;
        (uv_of(type, middle) < uv ? low : high) = middle;
    }
    return (low + high) / 2.0;
}

/// Returns whether a voltage is more than 10 uV above the range of appendix A.
inline bool is_above(unsigned type, double uv) {
    return uv > sensor(type).highest_uv + 10.0;
}
inline bool is_below(unsigned type, double uv) {
    return uv < sensor(type).lowest_uv - 10.0;
}

/// A converter of 16 bits with a reference of 2.5 V and gains of 128, 64 and 32.
class Converter {
  public:
    void restart_filter() { ignored_left_ = readings_ignored; }
    void read(double uv) {
        if (ignored_left_ > 0) {
            --ignored_left_;
            return;
        }
        const double size = std::fabs(uv);
        if (!(size < full_scale_uv(gain_))) {
            if (gain_ == 32) {
                open_ = true;
            } else {
                change_gain(gain_ / 2);
            }
            return;
        }
        const double step_uv = full_scale_uv(gain_) / 32768.0;
        uv_ = std::round(uv / step_uv) * step_uv;
        open_ = false;
        for (unsigned finer = 128; finer > gain_; finer /= 2) {
            if (size <= full_scale_uv(finer) * static_cast<double>(0.9F)) {
                change_gain(finer);
                return;
            }
        }
    }

    double uv() const { return uv_; }
    bool open() const { return open_; }
    unsigned gain() const { return gain_; }

  private:
    static constexpr unsigned readings_ignored = 3;  // after a restart of the filter, the fourth reading is the first
                                                     // valid one
    static double full_scale_uv(unsigned gain) { return 2.5e6 / gain; }
    void change_gain(unsigned gain) {
        gain_ = gain;
        restart_filter();
    }

    unsigned gain_{128};
    unsigned ignored_left_{0};
    double uv_{0.0};
    bool open_{false};
};

/// Returns the fraction of mains hum that the filter lets through. At the frequency of the filter the attenuation is
/// 110 dB (section 1.1). At the other mains frequency it is that of a sinc filter of fourth order.
inline double hum_left(unsigned filter_hz, unsigned mains_hz) {
    if (mains_hz != 50 && mains_hz != 60) {
        return 0.0;
    }
    if (mains_hz == filter_hz) {
        return static_cast<double>(3.1623e-6F);
    }
    return static_cast<double>(filter_hz == 50 ? 5.9e-4F : 1.33e-3F);
}

}  // namespace canproof::naive_tcs
