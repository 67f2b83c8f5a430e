// SPDX-License-Identifier: Apache-2.0
#include "host/conform/link/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace canproof::host::conform {

namespace {

/// Returns the nearest-rank percentile: the smallest time in `sorted` for which at least `percent` per cent of the
/// times are equal or less. `sorted` must not be empty.
std::uint64_t percentile(const std::vector<std::uint64_t>& sorted, std::size_t percent) {
    const std::size_t rank = (sorted.size() * percent + 99U) / 100U;
    return sorted[std::max<std::size_t>(rank, 1U) - 1U];
}

}  // namespace

Spread spread_of(std::vector<std::uint64_t> times) {
    if (times.empty()) {
        return {};
    }
    std::sort(times.begin(), times.end());
    const std::uint64_t sum = std::accumulate(times.begin(), times.end(), std::uint64_t{0});
    return {times.size(),       times.front(),          percentile(times, 50U),
            sum / times.size(), percentile(times, 99U), times.back()};
}

Histogram histogram_of(const Measured& measured) {
    const auto [smallest, largest] = std::minmax_element(measured.times.begin(), measured.times.end());
    double low = static_cast<double>(*smallest);
    double high = static_cast<double>(*largest);
    const double farthest = 2.0 * high;
    for (const auto& limits : {measured.of_mean, measured.of_each}) {
        for (const double limit : limits ? std::vector<double>{limits->least, limits->most} : std::vector<double>{}) {
            if (limit >= 0.0 && limit <= farthest) {
                low = std::min(low, limit);
                high = std::max(high, limit);
            }
        }
    }
    if (high - low < 1.0) {  // all times are the same
        low -= 0.5;
        high += 0.5;
    }
    Histogram histogram{low, (high - low) / static_cast<double>(Histogram::bins), {}};
    histogram.counts.resize(Histogram::bins);
    for (const std::uint64_t time : measured.times) {
        const double place = std::floor((static_cast<double>(time) - low) / histogram.width);
        ++histogram.counts[std::min(static_cast<std::size_t>(place), Histogram::bins - 1U)];
    }
    return histogram;
}

}  // namespace canproof::host::conform
