// SPDX-License-Identifier: Apache-2.0
// The faults of an injection campaign: which bit turns, and before which call of the device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace canproof::host {

struct RegionSize {
    std::string name;
    std::size_t bytes{0};
};

struct InjectedFault {
    std::size_t call{0};    ///< the bit turns before this call, counted from 0
    std::size_t region{0};  ///< place in the list of regions
    std::size_t byte{0};    ///< within the region
    unsigned bit{0};        ///< 0…7
};

/// Draws `count` faults: each call, and each bit of all regions, has the same probability. The same seed gives the same
/// faults on every machine. Sorted by call. Without a call or a byte there are none.
std::vector<InjectedFault> plan_faults(std::uint64_t seed, std::size_t count, std::size_t calls,
                                       const std::vector<RegionSize>& regions);

}  // namespace canproof::host
