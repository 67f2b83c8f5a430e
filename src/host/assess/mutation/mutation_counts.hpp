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
    /// In percent of all; 100 where there are none.
    double share_noticed() const;
    MutationCount& operator+=(const MutationCount& more);
};

using CountsByItem = std::map<std::string, MutationCount>;
CountsByItem count_by_item(const std::vector<MutationOutcome>& outcomes);
MutationCount total(const CountsByItem& counts);
/// Of mutants of code by file: those of the host's buses and replay, or the others.
MutationCount total_of(const CountsByItem& counts, bool host);

}  // namespace canproof::host
