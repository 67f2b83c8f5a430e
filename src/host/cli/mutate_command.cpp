// mutate: every generated cell altered, one at a time; survivors without a recorded reason by requirement.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/cli/sound_register.hpp"
#include "host/mutation/mutation.hpp"

namespace canproof::host {

namespace {

/// The cells of one item or of one device; all without a subject.
std::vector<AlteredCell> chosen_cells(std::vector<AlteredCell> cells, const Register& content,
                                      const std::string& subject) {
    if (subject.empty()) {
        return cells;
    }
    const Part* part = content.part(subject);
    const std::string start = part == nullptr ? subject : part->prefix + "-";
    const auto other = [&](const AlteredCell& cell) {
        return part == nullptr ? cell.item != subject : cell.item.rfind(start, 0) != 0;
    };
    cells.erase(std::remove_if(cells.begin(), cells.end(), other), cells.end());
    if (cells.empty()) {
        throw InputError{fmt::format("`{}` is no device and no item with generated cells", subject)};
    }
    return cells;
}

void print_survivors(const std::vector<MutationOutcome>& outcomes) {
    std::string item;
    for (const auto& outcome : outcomes) {
        if (!outcome.open()) {
            continue;
        }
        if (outcome.cell.item != item) {
            item = outcome.cell.item;
            fmt::print("{}{}\n", item, outcome.claimed ? "" : " (no test claims it)");
        }
        fmt::print("  {}: {}\n", outcome.cell.cell, outcome.cell.change);
    }
}

void show_progress(std::size_t done, std::size_t all) {
    if (isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r{} of {} cells{}", done, all, done == all ? "\n" : "");
    }
}

}  // namespace

int mutate(const MutateOptions& options) {
    const std::filesystem::path root{options.root};
    const auto programs =
        options.programs.empty() ? root / "build" / "mutation" : std::filesystem::path{options.programs};
    const MutationSetup setup{programs / "canproof_tests", programs / "canproof_properties", programs / "verdicts",
                              options.jobs};
    const auto records = read_survivor_records(root / "reports" / "mutation.toml");
    auto cells = chosen_cells(read_cells(setup.tests), sound_register(root / "spec"), options.subject);
    const bool whole = options.subject.empty() && options.sample == 0;
    if (options.sample != 0) {
        fmt::print("sample of {} of {} cells, seed {}\n", options.sample, cells.size(), options.seed);
        cells = sample_of(cells, options.sample, options.seed);
    }
    auto outcomes = mutate_cells(setup, cells, [&](std::size_t done) { show_progress(done, cells.size()); });
    const auto idle = justify(outcomes, records);
    print_survivors(outcomes);
    if (whole) {
        write_file(programs / "mutation.json", write_mutation_json(outcomes));
        for (const SurvivorRecord* record : idle) {
            fmt::print("reports/mutation.toml:{}: nothing survives that needs this record; remove it\n", record->line);
        }
    }
    const auto count = [&](const auto& which) { return std::count_if(outcomes.begin(), outcomes.end(), which); };
    const auto open = count([](const MutationOutcome& one) { return one.open(); });
    fmt::print("{} cells altered, {} noticed, {} survive with a reason, {} without\n", outcomes.size(),
               count([](const MutationOutcome& one) { return !one.killed_by.empty(); }),
               count([](const MutationOutcome& one) { return one.record != nullptr; }), open);
    return open == 0 && (!whole || idle.empty()) ? 0 : 1;
}

}  // namespace canproof::host
