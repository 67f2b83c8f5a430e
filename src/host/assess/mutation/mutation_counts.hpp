// How many alterations of each item were noticed.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Alterations, those noticed, and those that survive with a reason.
struct MutationCount {
    std::size_t altered{0};
    std::size_t noticed{0};
    std::size_t justified{0};
    std::size_t open() const { return altered - noticed - justified; }
    MutationCount& operator+=(const MutationCount& more);
};

using CountsByItem = std::map<std::string, MutationCount>;
CountsByItem count_by_item(const std::vector<MutationOutcome>& outcomes);
MutationCount total(const CountsByItem& counts);

}  // namespace canproof::host
