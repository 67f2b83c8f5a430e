// SPDX-License-Identifier: Apache-2.0
// Times that a conformance case measures, their limits and their statistics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host::conform {

/// Least and greatest accepted time in µs, both included.
struct TimeLimits {
    double least{0.0};
    double most{0.0};
};

/// Measured times of one kind, and the limits that the case sets for them.
struct Measured {
    std::vector<std::uint64_t> times;   ///< measured times in µs, in the order in which they were measured
    std::optional<TimeLimits> of_mean;  ///< limits of the mean of the times
    std::optional<TimeLimits> of_each;  ///< limits of each single time

    /// Adds the measured time `us` and its upper limit `most`, both in µs. All times share one limit: the greatest that
    /// was given.
    void add(std::uint64_t us, std::uint64_t most) {
        add_all({{us}, std::nullopt, TimeLimits{0.0, static_cast<double>(most)}});
    }
    /// Adds the times of `others`, which measure the same thing. Keeps, of the two limits of single times, the one with
    /// the greater maximum. Does not change the limits of the mean.
    void add_all(const Measured& others) {
        times.insert(times.end(), others.times.begin(), others.times.end());
        if (others.of_each && (!of_each || of_each->most < others.of_each->most)) {
            of_each = others.of_each;
        }
    }
};

/// Statistics of many times, in µs.
struct Spread {
    std::size_t count{0};
    std::uint64_t smallest{0};
    std::uint64_t median{0};  ///< smallest time for which at least half of the times are equal or less
    std::uint64_t mean{0};
    std::uint64_t percentile_99{0};  ///< smallest time for which at least 99 % of the times are equal or less
    std::uint64_t largest{0};
};
/// Returns the statistics of the times; all values are zero when there are no times.
Spread spread_of(std::vector<std::uint64_t> times);

/// A histogram: how many of the measured times are in each of several equal parts of a range.
struct Histogram {
    static constexpr std::size_t bins = 40;

    double low{0.0};    ///< start of the first bin in µs
    double width{0.0};  ///< width of each bin in µs; above 0
    std::vector<std::size_t> counts;
};
/// Counts the measured times in equal bins from the smallest to the largest time. The range also includes each limit
/// that is at most twice the largest time. `measured` must have at least one time.
Histogram histogram_of(const Measured& measured);

}  // namespace canproof::host::conform
