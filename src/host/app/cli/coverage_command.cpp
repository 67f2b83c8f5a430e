// SPDX-License-Identifier: Apache-2.0
// The `coverage` command: prints the coverage of the firmware and of the host code for buses and replay. Lists the
// places that no test reaches and that have no recorded reason.
#include "host/app/cli/coverage_command.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "host/app/cli/same_file.hpp"
#include "host/assess/coverage/cobertura.hpp"
#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_json.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/coverage/read_coverage.hpp"
#include "host/assess/coverage/stale_records.hpp"
#include "host/base/files.hpp"

namespace canproof::host {

namespace {

/// Returns the folder of a file: `src/firmware/canopen` for `src/firmware/canopen/node.cpp`.
std::string folder_of(const std::string& file) {
    return std::filesystem::path{file}.parent_path().generic_string();
}

void print_row(const std::string& name, const CoverageTotals& counts) {
    const auto cell = [](const CoverageCount& count) {
        return fmt::format("{:6.2f} % {:>11}", count.percent(), fmt::format("({}/{})", count.covered, count.total));
    };
    fmt::print("{:<32}{:>22}{:>22}{:>22}\n", name, cell(counts.lines), cell(counts.branches), cell(counts.conditions));
}

void print_counts(const std::vector<FileCoverage>& files) {
    std::map<std::string, CoverageTotals> folders;
    for (const auto& file : files) {
        folders[folder_of(file.file)].add(file);
    }
    fmt::print("{:<32}{:>22}{:>22}{:>22}\n", "", "lines", "branches", "MC/DC");
    for (const auto& [folder, counts] : folders) {
        print_row(folder, counts);
    }
    print_row("all firmware", totals_of(files));
    if (const CoverageTotals host = host_totals_of(files); host.lines.total != 0) {
        print_row("all of the host's", host);
    }
}

void print_verdict(const CoverageVerdict& verdict) {
    fmt::print("{} place(s) not reached, {} with a reason, {} open, {} record(s) unused; MC/DC {:.2f} %, {}{:.0f} %\n",
               verdict.gaps.size(), verdict.gaps.size() - verdict.open(), verdict.open(), verdict.unused.size(),
               verdict.conditions.percent(), verdict.enough_conditions() ? "at least " : "less than ",
               CoverageVerdict::least_conditions);
    if (verdict.host_conditions.total != 0) {
        fmt::print("the host's buses and replay: MC/DC {:.2f} %, {}{:.0f} %\n", verdict.host_conditions.percent(),
                   verdict.enough_host_conditions() ? "at least " : "less than ",
                   CoverageVerdict::least_host_conditions);
    }
}

/// Checks that the sources still contain the code of each record. A record gives the reason why no test reaches this
/// code. Needs no measured coverage. Returns the exit status: 1 when the code of a record is gone.
int check_records(const std::filesystem::path& place, const std::filesystem::path& root, const bool json) {
    const std::vector<CoverageRecord> records = read_coverage_records(place);
    const std::vector<CoverageRecord> stale = stale_records(records, root);
    if (json) {
        auto lines = nlohmann::ordered_json::array();
        for (const auto& record : stale) {
            lines.push_back({{"line", record.line}, {"file", record.file}, {"code", record.code}});
        }
        fmt::print("{}\n", nlohmann::ordered_json{{"records", records.size()}, {"stale", lines}}.dump(2));
        return stale.empty() ? 0 : 1;
    }
    for (const auto& record : stale) {
        fmt::print("{}:{}: `{}` is not in {} any more; remove the record or name the new code\n", place.string(),
                   record.line, record.code, record.file);
    }
    fmt::print("{} record(s), {} stale\n", records.size(), stale.size());
    return stale.empty() ? 0 : 1;
}

}  // namespace

int check_coverage(const CoverageOptions& options) {
    const auto place = std::filesystem::path{options.root} / "reports" / "coverage.toml";
    if (options.records_only) {
        return check_records(place, options.root, options.json);
    }
    refuse_same_file({options.cobertura}, {options.measured, place.string()});
    const std::vector<FileCoverage> files = read_coverage(options.measured, options.root);
    const CoverageVerdict verdict = judge_coverage(files, read_coverage_records(place));
    if (!options.cobertura.empty()) {
        write_file(options.cobertura, write_cobertura(files));
    }
    if (options.json) {
        fmt::print("{}", coverage_json(files, verdict));
        return verdict.holds() ? 0 : 1;
    }
    print_counts(files);
    for (const auto& [gap, reason] : verdict.gaps) {
        if (reason.empty()) {
            fmt::print("{}:{}: {} `{}` {}\n", gap.file, gap.line, gap.kind, gap.code, gap.missing);
        }
    }
    for (const auto& record : verdict.unused) {
        fmt::print(
            "{}:{}: the record of `{}` is not needed: tests reach its place, or its code is gone; remove the record\n",
            place.string(), record.line, record.code);
    }
    print_verdict(verdict);
    return verdict.holds() ? 0 : 1;
}

}  // namespace canproof::host
