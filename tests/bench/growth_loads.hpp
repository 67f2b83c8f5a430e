// What grows: work of a chosen size for the host and for the devices that it simulates.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace canproof::bench {

/// One kind of work. `prepare` makes everything that the work needs and gives the work, which is run once and counted.
struct Load {
    std::string name;
    std::string unit;                ///< what `size` counts
    std::vector<std::size_t> sizes;  ///< ascending, for every test run
    std::size_t largest;             ///< the size in full; counted on request
    double limit;                    ///< instructions for each unit in an optimised build, at the largest size
    std::function<std::function<void()>(std::size_t size)> prepare;
};

/// Each throws when the work did not do what it should.
const std::vector<Load>& loads();

}  // namespace canproof::bench
