// SPDX-License-Identifier: Apache-2.0
// Times that a case measures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace canproof::host::conform {

/// Limits in µs, both included.
struct TimeLimits {
    double least{0.0};
    double most{0.0};
};

/// Times of one kind, and the limits that the case sets for them.
struct Measured {
    std::vector<std::uint64_t> times;   ///< µs, in the order in which they were measured
    std::optional<TimeLimits> of_mean;  ///< limits of their mean
    std::optional<TimeLimits> of_each;  ///< limits of each of them

    /// Adds a time that may take up to `most`. The greatest of these limits stays.
    void add(std::uint64_t us, std::uint64_t most) {
        add_all({{us}, std::nullopt, TimeLimits{0.0, static_cast<double>(most)}});
    }
    /// Adds times of the same kind. The greater limit of each stays.
    void add_all(const Measured& others) {
        times.insert(times.end(), others.times.begin(), others.times.end());
        if (others.of_each && (!of_each || of_each->most < others.of_each->most)) {
            of_each = others.of_each;
        }
    }
};

/// A few statistics of many times, in µs.
struct Spread {
    std::size_t count{0};
    std::uint64_t smallest{0};
    std::uint64_t median{0};  ///< half of the times are not longer
    std::uint64_t mean{0};
    std::uint64_t percentile_99{0};  ///< 99 % of the times are not longer
    std::uint64_t largest{0};
};
/// Returns zeros when there are no times.
Spread spread_of(std::vector<std::uint64_t> times);

/// The number of times in each part of a range.
struct Histogram {
    static constexpr std::size_t bins = 40;

    double low{0.0};    ///< µs, start of the first bin
    double width{0.0};  ///< µs, of each bin; above 0
    std::vector<std::size_t> counts;
};
/// Counts the times in equal bins from the smallest to the largest. The range is widened to each limit that is at most
/// twice the largest time. `measured` has at least one time.
Histogram histogram_of(const Measured& measured);

}  // namespace canproof::host::conform
