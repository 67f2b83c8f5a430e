// SPDX-License-Identifier: Apache-2.0
// The page of the evidence pack with the hazards of the devices.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the body of the page as markup: each hazard with its safe state, and for each failure the requirements that
/// prevent it or the reason why none does.
std::string hazards_page(const PackInput& input);

/// Numbers of hazards, of all their failures, of open failures, and of failures that nothing prevents.
struct FailureCounts {
    std::size_t hazards{0};
    std::size_t failures{0};
    std::size_t open{0};         ///< failures for which a preventing requirement is not shown by passed tests
    std::size_t unprevented{0};  ///< failures that nothing prevents, each with a reason
};
FailureCounts count_failures(const PackInput& input);

}  // namespace canproof::host
