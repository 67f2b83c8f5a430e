// Structural coverage of the firmware, and of the host's buses and replay beside it: what llvm-cov measured, and what
// no run reached.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace canproof::host {

/// Covered and counted: lines, branches (each way of a decision counts), MC/DC conditions, functions.
struct CoverageCount {
    std::size_t covered{0};
    std::size_t total{0};

    void add(const CoverageCount& other);
    /// In percent; 100 where there is nothing to cover.
    double percent() const;
};

/// Something that no run reached. `code` is its text in the source, by which a record names it.
struct CoverageGap {
    std::string kind;  ///< function, line, branch or condition
    std::string file;  ///< relative to the project's folder
    unsigned line{0};
    std::string code;
    std::string missing;  ///< in words: never true, not shown to decide, …
};

struct FileCoverage {
    std::string file;
    std::map<unsigned, unsigned long long> lines;  ///< executions by line number, lines with code only
    /// By line: branches covered and there.
    std::map<unsigned, CoverageCount> line_branches;
    CoverageCount functions;
    CoverageCount branches;
    CoverageCount conditions;
    std::vector<CoverageGap> gaps;

    CoverageCount line_count() const;
    /// Of the host's buses and replay, not of the firmware.
    bool is_host() const;
};

/// Over several files.
struct CoverageTotals {
    CoverageCount lines;
    CoverageCount branches;
    CoverageCount conditions;

    void add(const FileCoverage& file);
};

/// Over the files of the firmware.
CoverageTotals totals_of(const std::vector<FileCoverage>& files);
/// Over the others.
CoverageTotals host_totals_of(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
