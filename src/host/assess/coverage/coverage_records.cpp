// SPDX-License-Identifier: Apache-2.0
#include "host/assess/coverage/coverage_records.hpp"

#include <algorithm>

#include "host/assess/coverage/coverage.hpp"
#include "host/register/toml_records.hpp"

namespace canproof::host {

namespace {

bool is_of(const std::string& file, const CoverageRecord& record) {
    const bool is_folder = !record.file.empty() && record.file.back() == '/';
    return is_folder ? file.rfind(record.file, 0) == 0 : file == record.file;
}

bool matches(const CoverageRecord& record, const CoverageGap& gap) {
    return record.kind == gap.kind && record.code == gap.code && is_of(gap.file, record);
}

}  // namespace

std::vector<CoverageRecord> read_coverage_records(const std::filesystem::path& file) {
    std::vector<CoverageRecord> records;
    if (!std::filesystem::exists(file)) {
        return records;
    }
    read_toml_records(file, [&records](TomlItem& whole) {
        for (auto& item : whole.items("record")) {
            records.push_back({item.text("file"), item.word("kind", {"function", "line", "branch", "condition"}, ""),
                               item.text("code"), item.text("reason"), item.place().line});
            item.finish();
        }
    });
    return records;
}

std::size_t CoverageVerdict::open() const {
    return static_cast<std::size_t>(
        std::count_if(gaps.begin(), gaps.end(), [](const JudgedGap& one) { return one.reason.empty(); }));
}

CoverageVerdict judge_coverage(const std::vector<FileCoverage>& files, const std::vector<CoverageRecord>& records) {
    CoverageVerdict verdict;
    std::vector<bool> used(records.size(), false);
    for (const auto& file : files) {
        for (const auto& gap : file.gaps) {
            if (file.is_host() && gap.kind != "condition") {
                // the verdict on files of the host considers MC/DC conditions only, so their other gaps need no record
                continue;
            }
            JudgedGap judged{gap, ""};
            for (std::size_t i = 0; i < records.size(); ++i) {
                if (matches(records[i], gap)) {
                    used[i] = true;
                    judged.reason = records[i].reason;
                }
            }
            verdict.gaps.push_back(std::move(judged));
        }
    }
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (!used[i]) {
            verdict.unused.push_back(records[i]);
        }
    }
    verdict.conditions = totals_of(files).conditions;
    verdict.host_conditions = host_totals_of(files).conditions;
    return verdict;
}

}  // namespace canproof::host
