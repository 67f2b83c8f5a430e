// SPDX-License-Identifier: Apache-2.0
// Work of a chosen size for the host and for the devices that it simulates.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace canproof::bench {

/// One kind of work. `prepare` makes everything that the work needs and returns the work as a function. The program
/// calls this function once and counts its instructions.
struct Load {
    std::string name;
    std::string unit;                ///< the unit of `size`
    std::vector<std::size_t> sizes;  ///< in ascending order; each test run counts the instructions at these
    std::size_t largest;             ///< the full size; its instructions are counted only on request
    double limit;                    ///< instructions per unit in an optimised build, at the largest size
    std::function<std::function<void()>(std::size_t size)> prepare;
};

/// Returns all loads. The work of a load throws if its result is wrong.
const std::vector<Load>& loads();

}  // namespace canproof::bench
