// SPDX-License-Identifier: Apache-2.0
#include "host/assess/inject/fault_plan.hpp"

#include <algorithm>
#include <random>
#include <tuple>

namespace canproof::host {

namespace {

/// Returns a random number below `limit`. Does not use std::uniform_int_distribution, which differs between standard
/// libraries. The remainder favours small numbers by less than limit / 2^64.
std::size_t below(std::mt19937_64& random, std::size_t limit) {
    return static_cast<std::size_t>(random() % limit);
}

}  // namespace

std::vector<InjectedFault> plan_faults(std::uint64_t seed, std::size_t count, std::size_t calls,
                                       const std::vector<RegionSize>& regions) {
    std::size_t bytes = 0;
    for (const RegionSize& region : regions) {
        bytes += region.bytes;
    }
    if (calls == 0 || bytes == 0) {
        return {};
    }
    std::mt19937_64 random{seed};
    std::vector<InjectedFault> faults(count);
    for (InjectedFault& fault : faults) {
        fault.call = below(random, calls);
        fault.byte = below(random, bytes);
        fault.bit = static_cast<unsigned>(below(random, 8));
        while (fault.byte >= regions[fault.region].bytes) {
            fault.byte -= regions[fault.region].bytes;
            ++fault.region;
        }
    }
    std::sort(faults.begin(), faults.end(), [](const InjectedFault& a, const InjectedFault& b) {
        return std::tie(a.call, a.region, a.byte, a.bit) < std::tie(b.call, b.region, b.byte, b.bit);
    });
    return faults;
}

}  // namespace canproof::host
