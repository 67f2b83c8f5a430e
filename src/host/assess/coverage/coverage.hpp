// Structural coverage of the firmware: what llvm-cov measured, and what no run reached.
#pragma once

#include <filesystem>
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
};

/// Over several files.
struct CoverageTotals {
    CoverageCount lines;
    CoverageCount branches;
    CoverageCount conditions;

    void add(const FileCoverage& file);
};

CoverageTotals totals_of(const std::vector<FileCoverage>& files);

/// Reads what `llvm-cov export --format=text` wrote, for the files of the firmware below root. Instantiations of a
/// template count together. Throws InputError when the file is no such export or a source is missing.
std::vector<FileCoverage> read_coverage(const std::filesystem::path& file, const std::filesystem::path& root);

/// A gap that is known, with the reason why it stays. Matches gaps of this kind and code in a file or below a folder.
struct CoverageRecord {
    std::string file;
    std::string kind;
    std::string code;
    std::string reason;
    unsigned line{0};  ///< of the record
};

/// Reads reports/coverage.toml. Throws InputError with file, line and fix.
std::vector<CoverageRecord> read_coverage_records(const std::filesystem::path& file);

struct JudgedGap {
    CoverageGap gap;
    std::string reason;  ///< empty: open
};

struct CoverageVerdict {
    /// MC/DC that is asked for, in percent: records explain no more than the rest.
    static constexpr double least_conditions = 99.0;

    std::vector<JudgedGap> gaps;
    std::vector<CoverageRecord> unused;  ///< records that match nothing: the code has moved on
    CoverageCount conditions;

    std::size_t open() const;
    bool enough_conditions() const { return conditions.percent() >= least_conditions; }
    /// No open gap, no unused record, and enough conditions.
    bool holds() const { return open() == 0 && unused.empty() && enough_conditions(); }
};

CoverageVerdict judge_coverage(const std::vector<FileCoverage>& files, const std::vector<CoverageRecord>& records);

/// The records whose text no longer stands in the sources that they name, below `root`; nothing needs to be measured.
std::vector<CoverageRecord> stale_records(const std::vector<CoverageRecord>& records,
                                          const std::filesystem::path& root);

/// In the form of Cobertura, which build servers read.
std::string write_cobertura(const std::vector<FileCoverage>& files);

}  // namespace canproof::host
