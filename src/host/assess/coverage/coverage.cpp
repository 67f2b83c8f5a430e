// SPDX-License-Identifier: Apache-2.0
#include "host/assess/coverage/coverage.hpp"

#include <algorithm>

namespace canproof::host {

void CoverageCount::add(const CoverageCount& other) {
    covered += other.covered;
    total += other.total;
}

double CoverageCount::percent() const {
    return total == 0 ? 100.0 : 100.0 * static_cast<double>(covered) / static_cast<double>(total);
}

CoverageCount FileCoverage::line_count() const {
    CoverageCount count;
    for (const auto& line : lines) {
        count.add({line.second == 0 ? 0U : 1U, 1});
    }
    return count;
}

bool FileCoverage::is_host() const {
    return file.rfind("src/host/", 0) == 0;
}

void CoverageTotals::add(const FileCoverage& file) {
    lines.add(file.line_count());
    branches.add(file.branches);
    conditions.add(file.conditions);
}

namespace {

CoverageTotals totals_where(const std::vector<FileCoverage>& files, bool host) {
    CoverageTotals totals;
    for (const auto& file : files) {
        if (file.is_host() == host) {
            totals.add(file);
        }
    }
    return totals;
}

}  // namespace

CoverageTotals totals_of(const std::vector<FileCoverage>& files) {
    return totals_where(files, false);
}

CoverageTotals host_totals_of(const std::vector<FileCoverage>& files) {
    return totals_where(files, true);
}

}  // namespace canproof::host
