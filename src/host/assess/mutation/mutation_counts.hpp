// SPDX-License-Identifier: Apache-2.0
// Counts for each item how many alterations the tests notice.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Numbers of alterations: all alterations, those that a test noticed, and those that no test noticed but a record
/// explains.
struct MutationCount {
    std::size_t altered{0};
    std::size_t noticed{0};
    std::size_t justified{0};
    std::size_t open() const { return altered - noticed - justified; }
    /// Returns the noticed share of all alterations in per cent; 100 when there are none.
    double share_noticed() const;
    MutationCount& operator+=(const MutationCount& more);
};

using CountsByItem = std::map<std::string, MutationCount>;
CountsByItem count_by_item(const std::vector<MutationOutcome>& outcomes);
MutationCount total(const CountsByItem& counts);
/// Returns the sum of the counts for the mutants of the host's buses and replay if `host` is true, otherwise for all
/// other mutants.
MutationCount total_of(const CountsByItem& counts, bool host);

}  // namespace canproof::host
