// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/mutation_counts.hpp"

#include "host/assess/mutation/mutation_table.hpp"

namespace canproof::host {

MutationCount& MutationCount::operator+=(const MutationCount& more) {
    altered += more.altered;
    noticed += more.noticed;
    justified += more.justified;
    return *this;
}

double MutationCount::share_noticed() const {
    return altered == 0 ? 100.0 : 100.0 * static_cast<double>(noticed) / static_cast<double>(altered);
}

CountsByItem count_by_item(const std::vector<MutationOutcome>& outcomes) {
    CountsByItem counts;
    for (const MutationOutcome& outcome : outcomes) {
        counts[outcome.cell.item] += {1, outcome.killed_by.empty() ? 0U : 1U, outcome.record == nullptr ? 0U : 1U};
    }
    return counts;
}

MutationCount total(const CountsByItem& counts) {
    MutationCount all;
    for (const auto& [item, count] : counts) {
        all += count;
    }
    return all;
}

MutationCount total_of(const CountsByItem& counts, bool host) {
    MutationCount all;
    for (const auto& [file, count] : counts) {
        if (is_host(file) == host) {
            all += count;
        }
    }
    return all;
}

}  // namespace canproof::host
