// SPDX-License-Identifier: Apache-2.0
// The faults of an injection campaign: for each, which bit is inverted, and before which call of the device.
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
    std::size_t call{0};    ///< the bit is inverted before this call; calls count from 0
    std::size_t region{0};  ///< number of the memory region in the list of regions
    std::size_t byte{0};    ///< number of the byte in the region
    unsigned bit{0};        ///< number of the bit, 0 to 7
};

/// Draws `count` faults, sorted by call. Each call and each bit of all regions has the same probability. The same seed
/// gives the same faults on every machine. Returns no faults when there is no call or no byte.
std::vector<InjectedFault> plan_faults(std::uint64_t seed, std::size_t count, std::size_t calls,
                                       const std::vector<RegionSize>& regions);

}  // namespace canproof::host
