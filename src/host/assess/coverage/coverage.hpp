// SPDX-License-Identifier: Apache-2.0
// Structural coverage of the firmware, and of the host's code for buses and replay: the counts that llvm-cov measured,
// and the places that no run reached.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// The number of covered elements and the number of all elements. Elements are lines, branches (one for each outcome of
/// a decision), MC/DC conditions or functions.
struct CoverageCount {
    std::size_t covered{0};
    std::size_t total{0};

    void add(const CoverageCount& other);
    /// Returns the share of covered elements in per cent; 100 when there is no element.
    double percent() const;
};

/// An element that no run covered. `code` is the element's text in the source, or the name of the function. A record in
/// reports/coverage.toml identifies the element by this text.
struct CoverageGap {
    std::string kind;  ///< function, line, branch or condition
    std::string file;  ///< path relative to the project's folder
    unsigned line{0};
    std::string code;
    std::string missing;  ///< the outcome that is missing: `never true`, `not shown to decide alone` …
};

struct FileCoverage {
    std::string file;
    std::map<unsigned, unsigned long long> lines;  ///< executions by line number; only lines with code
    /// Numbers of covered and of all branches, by line number.
    std::map<unsigned, CoverageCount> line_branches;
    CoverageCount functions;
    CoverageCount branches;
    CoverageCount conditions;
    std::vector<CoverageGap> gaps;

    CoverageCount line_count() const;
    /// Returns whether the file belongs to the host's buses and replay. All other measured files belong to the
    /// firmware.
    bool is_host() const;
};

/// Sums of the counts of several files.
struct CoverageTotals {
    CoverageCount lines;
    CoverageCount branches;
    CoverageCount conditions;

    void add(const FileCoverage& file);
};

/// Returns the sums of the counts over the files of the firmware.
CoverageTotals totals_of(const std::vector<FileCoverage>& files);
/// Returns the sums of the counts over the files of the host.
CoverageTotals host_totals_of(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
