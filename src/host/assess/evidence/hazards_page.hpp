// The page of hazards.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Each hazard with its outputs, its safe state, and what prevents each failure. Gives the markup of its body.
std::string hazards_page(const PackInput& input);

/// Failures of all hazards, and those that nothing prevents.
struct FailureCounts {
    std::size_t hazards{0};
    std::size_t failures{0};
    std::size_t open{0};         ///< a requirement that prevents one is not shown
    std::size_t unprevented{0};  ///< with a reason
};
FailureCounts count_failures(const PackInput& input);

}  // namespace canproof::host
