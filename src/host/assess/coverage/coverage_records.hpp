// SPDX-License-Identifier: Apache-2.0
// Reads reports/coverage.toml. Each record in it names a coverage gap (code that no test reaches) and gives the reason.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

/// A record of a coverage gap, with the reason why no test reaches it. The record matches each gap with this kind and
/// this code in `file`. A `file` that ends with a slash is a folder: the record matches in each file below it.
struct CoverageRecord {
    std::string file;
    std::string kind;
    std::string code;
    std::string reason;
    unsigned line{0};  ///< line in reports/coverage.toml where the record begins
};

/// Reads reports/coverage.toml; returns no records when the file does not exist. For invalid content, throws InputError
/// with file, line and fix.
std::vector<CoverageRecord> read_coverage_records(const std::filesystem::path& file);

struct JudgedGap {
    CoverageGap gap;
    std::string reason;  ///< reason of the record that matches; empty: the gap is open
};

struct CoverageVerdict {
    /// Required MC/DC of the firmware in per cent. A recorded gap counts as not covered, too.
    static constexpr double least_conditions = 99.0;
    /// Required MC/DC of the host's buses and replay in per cent.
    static constexpr double least_host_conditions = 95.0;

    std::vector<JudgedGap> gaps;
    std::vector<CoverageRecord> unused;  ///< records that match no gap: the code has changed, or a run covers it now
    CoverageCount conditions;            ///< conditions of the firmware
    CoverageCount host_conditions;       ///< conditions of the host's buses and replay

    std::size_t open() const;
    bool enough_conditions() const { return conditions.percent() >= least_conditions; }
    bool enough_host_conditions() const { return host_conditions.percent() >= least_host_conditions; }
    /// Returns whether there is no open gap and no unused record, and both MC/DC figures are sufficient.
    bool holds() const { return open() == 0 && unused.empty() && enough_conditions() && enough_host_conditions(); }
};

CoverageVerdict judge_coverage(const std::vector<FileCoverage>& files, const std::vector<CoverageRecord>& records);

}  // namespace canproof::host
