// coverage: what no test reached in the firmware, and whether each such place has its reason.
#include <fmt/format.h>

#include <map>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/coverage/coverage.hpp"

namespace canproof::host {

namespace {

/// `src/firmware/canopen` of `src/firmware/canopen/node.cpp`.
std::string folder_of(const std::string& file) {
    return std::filesystem::path{file}.parent_path().generic_string();
}

void print_row(const std::string& name, const CoverageTotals& counts) {
    const auto cell = [](const CoverageCount& count) {
        return fmt::format("{:6.2f} % {:>11}", count.percent(), fmt::format("({}/{})", count.covered, count.total));
    };
    fmt::print("{:<24}{:>22}{:>22}{:>22}\n", name, cell(counts.lines), cell(counts.branches), cell(counts.conditions));
}

void print_counts(const std::vector<FileCoverage>& files) {
    std::map<std::string, CoverageTotals> folders;
    for (const auto& file : files) {
        folders[folder_of(file.file)].add(file);
    }
    fmt::print("{:<24}{:>22}{:>22}{:>22}\n", "", "lines", "branches", "MC/DC");
    for (const auto& [folder, counts] : folders) {
        print_row(folder, counts);
    }
    print_row("all", totals_of(files));
}

}  // namespace

int check_coverage(const CoverageOptions& options) {
    const std::vector<FileCoverage> files = read_coverage(options.measured, options.root);
    const auto place = std::filesystem::path{options.root} / "reports" / "coverage.toml";
    const CoverageVerdict verdict = judge_coverage(files, read_coverage_records(place));
    print_counts(files);
    for (const auto& [gap, reason] : verdict.gaps) {
        if (reason.empty()) {
            fmt::print("{}:{}: {} `{}` {}\n", gap.file, gap.line, gap.kind, gap.code, gap.missing);
        }
    }
    for (const auto& record : verdict.unused) {
        fmt::print("{}:{}: the record of `{}` matches nothing; remove it\n", place.string(), record.line, record.code);
    }
    if (!options.cobertura.empty()) {
        write_file(options.cobertura, write_cobertura(files));
    }
    fmt::print("{} place(s) not reached, {} with a reason, {} open, {} record(s) unused\n", verdict.gaps.size(),
               verdict.gaps.size() - verdict.open(), verdict.open(), verdict.unused.size());
    return verdict.open() == 0 && verdict.unused.empty() ? 0 : 1;
}

}  // namespace canproof::host
