// SPDX-License-Identifier: Apache-2.0
// The `mutate` command: makes one alteration at a time and checks whether a test notices it. It alters each generated
// cell (a value in a generated table) or, with --code, the expressions and statements of the firmware and of the host's
// buses and replay. It prints, by item or file, the survivors (alterations that no test notices) without a recorded
// reason.
#include "host/app/cli/mutate_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/app/cli/progress.hpp"
#include "host/app/cli/sound_register.hpp"
#include "host/assess/mutation/code_exhibit.hpp"
#include "host/assess/mutation/code_figures.hpp"
#include "host/assess/mutation/code_mutation.hpp"
#include "host/assess/mutation/kill_run.hpp"
#include "host/assess/mutation/mutation.hpp"
#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/mutation_shard.hpp"
#include "host/assess/mutation/survivor_records.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_folder.hpp"
#include "host/base/source_hash.hpp"

namespace canproof::host {

namespace {

/// Removes the cells (values in generated tables) of shared rules that come with an installed canproof, because
/// canproof's own tests cover them.
void drop_inherited(std::vector<AlteredCell>& cells, const Register& content) {
    const auto inherited = [&](const AlteredCell& cell) {
        return std::any_of(content.parts.begin(), content.parts.end(), [&](const Part& part) {
            return part.inherited && cell.item.rfind(part.prefix + "-", 0) == 0;
        });
    };
    cells.erase(std::remove_if(cells.begin(), cells.end(), inherited), cells.end());
}

/// Returns the cells of the item or device that the user names; without a name, all cells of the project.
std::vector<AlteredCell> chosen_cells(std::vector<AlteredCell> cells, const Register& content,
                                      const std::string& subject) {
    drop_inherited(cells, content);
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
        throw InputError{fmt::format(
            "`{}` is no device and no item with generated cells; name a device or an item, or leave the argument "
            "out to test all cells",
            subject)};
    }
    return cells;
}

std::vector<AlteredCell> chosen_mutants(std::vector<AlteredCell> mutants, const std::string& file) {
    const auto other = [&](const AlteredCell& mutant) { return mutant.item.find(file) == std::string::npos; };
    mutants.erase(std::remove_if(mutants.begin(), mutants.end(), other), mutants.end());
    if (mutants.empty()) {
        throw InputError{fmt::format(
            "no file with mutants has `{}` in its path; give another part of a path, or leave the argument out to "
            "test all files",
            file)};
    }
    return mutants;
}

void print_survivors(const std::vector<MutationOutcome>& outcomes) {
    std::string item;
    for (const auto& outcome : outcomes) {
        if (!outcome.open()) {
            continue;
        }
        if (outcome.cell.item != item) {
            item = outcome.cell.item;
            fmt::print("{}\n", item);
        }
        fmt::print("  {}: {}{}\n", outcome.cell.cell, outcome.cell.change,
                   outcome.claimed ? "" : " (no test depends on it)");
    }
}

void print_count(const std::string& what, const MutationCount& count) {
    fmt::print("{} {} altered, {} noticed, {} survive with a reason, {} without a reason\n", count.altered, what,
               count.noticed, count.justified, count.open());
}

/// Prints how many alterations were made, how many of them a test noticed, and how many survive with and without a
/// recorded reason. With `code`, prints the numbers of the host's mutants separately.
void print_counts(const CountsByItem& counts, bool code) {
    const MutationCount host = total_of(counts, true);
    if (!code || host.altered == 0) {
        print_count(code ? "places" : "cells", total(counts));
        return;
    }
    if (const MutationCount firmware = total_of(counts, false); firmware.altered != 0) {
        print_count("places", firmware);
    }
    print_count("places of the host's buses and replay", host);
    fmt::print("{:.1f} % of the host's mutants are noticed\n", host.share_noticed());
}

/// Updates reports/kills.csv, the record of the mutants that each test notices. Writes the file after every 100 tests,
/// so that an interruption keeps the results so far.
int write_kills(const MutateOptions& options, const std::filesystem::path& programs) {
    const std::filesystem::path root{options.root};
    const auto file = root / "reports" / "kills.csv";
    constexpr std::size_t step = 100;
    const auto progress = [&](std::size_t done, std::size_t all, const KillRecord& known) {
        show_progress(done, all);
        if (done % step == 0) {
            write_file(file, write_kill_record(known));
        }
    };
    const KillRecord record =
        record_kills({root, programs, options.jobs}, sound_register(root / "spec"), read_kill_record(file), progress);
    write_file(file, write_kill_record(record));
    const auto idle =
        std::count_if(record.begin(), record.end(), [](const auto& line) { return line.second.kills.empty(); });
    if (options.json) {
        fmt::print("{}\n", nlohmann::ordered_json{{"tests", record.size()}, {"notice_nothing", idle}}.dump(2));
    } else {
        fmt::print("{} test(s) judged; {} notice no mutant of the items that they verify\n", record.size(), idle);
    }
    return 0;
}

/// Runs the tests in `programs` for each alteration in `cells` and returns whether a test noticed it. `count` is the
/// number of all alterations that the programs contain.
std::vector<MutationOutcome> judge(const MutateOptions& options, const std::filesystem::path& programs,
                                   const std::vector<AlteredCell>& cells, std::size_t count,
                                   const std::vector<SurvivorRecord>& records) {
    const auto progress = [&](std::size_t done) { show_progress(done, cells.size()); };
    if (options.code) {
        const auto is_explained = [&](const AlteredCell& mutant) {
            return std::any_of(records.begin(), records.end(),
                               [&](const SurvivorRecord& record) { return is_about(record, mutant); });
        };
        return mutate_code(
            {programs / "code_mutants", programs / "verdicts" / "code_mutants", options.jobs, is_explained}, cells,
            count, progress);
    }
    return mutate_cells(
        {programs / "canproof_tests", programs / "canproof_properties", programs / "verdicts", options.jobs}, cells,
        progress);
}

/// Tests one shard of `cells` (the part for one of several machines) and writes its outcomes for `--merge`. `count` is
/// the number of all alterations that the programs contain.
int judge_shard(const MutateOptions& options, const std::filesystem::path& programs,
                const std::vector<AlteredCell>& cells, std::size_t count, const std::vector<SurvivorRecord>& records) {
    const std::string sources = source_hash(options.root);
    const auto share = share_of(cells, *options.shard);
    const auto file = programs / "shards" / mutation_shard_name(options.code, *options.shard);
    write_file(file, write_mutation_shard(*options.shard, sources, judge(options, programs, share, count, records)));
    if (options.json) {
        const nlohmann::ordered_json json{{"shard", options.shard->text()},
                                          {"judged", share.size()},
                                          {"of", cells.size()},
                                          {"file", file.generic_string()}};
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("shard {}: {} of {} alterations judged: {}\n", options.shard->text(), share.size(), cells.size(),
                   file.string());
    }
    return 0;
}

/// Returns one line for each record of a survivor (an alteration that no test notices): the file, the line of the
/// record, and `what`.
std::vector<std::string> lines_about(const std::vector<const SurvivorRecord*>& records,
                                     const std::filesystem::path& file, const char* what) {
    std::vector<std::string> lines;
    for (const SurvivorRecord* record : records) {
        lines.push_back(fmt::format("{}:{}: {}; remove the record", file.string(), record->line, what));
    }
    return lines;
}

/// Saves the outcomes of a complete run for the evidence pack.
void keep(const std::vector<MutationOutcome>& outcomes, const MutateOptions& options,
          const std::filesystem::path& programs) {
    write_file(programs / (options.code ? "code_mutation.json" : "mutation.json"), write_mutation_json(outcomes));
    if (options.code) {
        replace_folder(std::filesystem::path{options.root} / "build" / "exhibits" / "code-mutation",
                       code_exhibit(outcomes));
    }
}

/// Replaces the mutation figures of the files in `outcomes` in reports/code_figures.csv.
void keep_figures(const std::vector<MutationOutcome>& outcomes, const std::filesystem::path& root) {
    const auto file = root / "reports" / "code_figures.csv";
    CodeFigures figures = read_code_figures(file);
    note_figures(figures, outcomes, root);
    write_file(file, write_code_figures(figures));
}

/// Prints the mutation figures of reports/code_figures.csv by layer, and the files that changed since their last
/// mutation run or had none.
int print_table(const std::filesystem::path& root, const std::vector<AlteredCell>& mutants) {
    const LayerTable table = layer_table(read_code_figures(root / "reports" / "code_figures.csv"), mutants, root);
    fmt::print("{}", table.text);
    for (const std::string& file : table.unjudged) {
        fmt::print("not judged in its present form: {}\n", file);
    }
    return table.open == 0 && table.unjudged.empty() ? 0 : 1;
}

/// Prints, as lines, the faults in reports/mutation.toml (`faults`), the alterations that no test noticed, and the
/// numbers of alterations.
void print_run(const std::vector<MutationOutcome>& outcomes, const std::vector<std::string>& faults, bool code) {
    for (const auto& fault : faults) {
        fmt::print("{}\n", fault);
    }
    print_survivors(outcomes);
    print_counts(count_by_item(outcomes), code);
}

/// Returns the alterations that this run tests: those of the item, device or file that the user names, or with --sample
/// a random sample of these.
std::vector<AlteredCell> alterations_for(const MutateOptions& options, const std::vector<AlteredCell>& all) {
    auto cells = options.code
                     ? chosen_mutants(all, options.subject)
                     : chosen_cells(all, sound_register(std::filesystem::path{options.root} / "spec"), options.subject);
    if (options.sample == 0) {
        return cells;
    }
    if (!options.json) {
        fmt::print("sample of {} of {} alterations, seed {}\n", options.sample, cells.size(), options.seed);
    }
    return sample_of(cells, options.sample, options.seed);
}

}  // namespace

int mutate(const MutateOptions& options) {
    const std::filesystem::path root{options.root};
    const auto programs =
        options.programs.empty() ? root / "build" / "mutation" : std::filesystem::path{options.programs};
    if (options.kills) {
        return write_kills(options, programs);
    }
    const auto record_file = root / "reports" / (options.code ? "code_mutation.toml" : "mutation.toml");
    const auto records = read_survivor_records(record_file);
    const auto all = read_cells(programs / (options.code ? "code_mutants" : "canproof_tests"));
    if (options.table) {
        return print_table(root, all);
    }
    auto faults = lines_about(without_alteration(records, all), record_file, "no alteration matches this record");
    const auto cells = alterations_for(options, all);
    if (options.shard) {
        return judge_shard(options, programs, cells, all.size(), records);
    }
    auto outcomes = options.merge.empty() ? judge(options, programs, cells, all.size(), records)
                                          : merge_mutation_shards(options.merge, options.code, cells);
    const auto unneeded = justify(outcomes, records);
    if (options.code && options.sample == 0) {
        keep_figures(outcomes, root);
    }
    if (options.subject.empty() && options.sample == 0) {
        const auto more = lines_about(unneeded, record_file, "this record explains no alteration that survives");
        faults.insert(faults.end(), more.begin(), more.end());
        keep(outcomes, options, programs);
    }
    if (options.json) {
        fmt::print("{}", write_mutation_run_json(outcomes, faults));
    } else {
        print_run(outcomes, faults, options.code);
    }
    return total(count_by_item(outcomes)).open() == 0 && faults.empty() ? 0 : 1;
}

}  // namespace canproof::host
