// SPDX-License-Identifier: Apache-2.0
// Work of a chosen size for the host and for the devices that it simulates.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace canproof::bench {

/// One kind of work. `prepare` makes everything that the work needs and returns the work, which is run once and
/// counted.
struct Load {
    std::string name;
    std::string unit;                ///< the unit of `size`
    std::vector<std::size_t> sizes;  ///< ascending, for every test run
    std::size_t largest;             ///< the full size; counted on request
    double limit;                    ///< instructions per unit in an optimised build, at the largest size
    std::function<std::function<void()>(std::size_t size)> prepare;
};

/// Returns all loads. A load throws when its work gives a wrong result.
const std::vector<Load>& loads();

}  // namespace canproof::bench
