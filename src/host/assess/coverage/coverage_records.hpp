// The records of reports/coverage.toml: which gaps are known, and whether they explain all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// A gap that is known, with the reason why it stays. Matches gaps of this kind and code in a file or below a folder.
struct CoverageRecord {
    std::string file;
    std::string kind;
    std::string code;
    std::string reason;
    unsigned line{0};  ///< of the record
};

/// Reads reports/coverage.toml; there are no records without the file. Throws InputError with file, line and mend.
std::vector<CoverageRecord> read_coverage_records(const std::filesystem::path& file);

struct JudgedGap {
    CoverageGap gap;
    std::string reason;  ///< empty: open
};

struct CoverageVerdict {
    /// MC/DC that is asked for, in percent: records explain no more than the rest.
    static constexpr double least_conditions = 99.0;
    /// The same of the host's buses and replay.
    static constexpr double least_host_conditions = 95.0;

    std::vector<JudgedGap> gaps;
    std::vector<CoverageRecord> unused;  ///< records that match nothing: the code has moved on
    CoverageCount conditions;            ///< of the firmware
    CoverageCount host_conditions;       ///< of the host's buses and replay

    std::size_t open() const;
    bool enough_conditions() const { return conditions.percent() >= least_conditions; }
    bool enough_host_conditions() const { return host_conditions.percent() >= least_host_conditions; }
    /// No open gap, no unused record, and enough conditions of both.
    bool holds() const { return open() == 0 && unused.empty() && enough_conditions() && enough_host_conditions(); }
};

CoverageVerdict judge_coverage(const std::vector<FileCoverage>& files, const std::vector<CoverageRecord>& records);

}  // namespace canproof::host
