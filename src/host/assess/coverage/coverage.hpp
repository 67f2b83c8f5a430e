// SPDX-License-Identifier: Apache-2.0
// Structural coverage of the firmware, and of the host's buses and replay: the measurement of llvm-cov and the places
// that no run reached.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// Number of covered elements and of all elements: lines, branches (each outcome of a decision counts), MC/DC
/// conditions or functions.
struct CoverageCount {
    std::size_t covered{0};
    std::size_t total{0};

    void add(const CoverageCount& other);
    /// Returns the share in per cent; 100 when there is no element.
    double percent() const;
};

/// An element that no run reached. `code` is its text in the source; a record refers to the element by this text.
struct CoverageGap {
    std::string kind;  ///< function, line, branch or condition
    std::string file;  ///< relative to the project's folder
    unsigned line{0};
    std::string code;
    std::string missing;  ///< in words: never true, not shown to decide alone, …
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
    /// Returns whether the file belongs to the host's buses and replay instead of the firmware.
    bool is_host() const;
};

/// Counts over several files.
struct CoverageTotals {
    CoverageCount lines;
    CoverageCount branches;
    CoverageCount conditions;

    void add(const FileCoverage& file);
};

/// Returns the counts over the files of the firmware.
CoverageTotals totals_of(const std::vector<FileCoverage>& files);
/// Returns the counts over the files of the host.
CoverageTotals host_totals_of(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
