#include "host/mutation/code_mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <tuple>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

/// Of processor time, unmutated; tests/mutation/main.cpp ends a mutant after ten.
constexpr double most_seconds = 1.5;

}  // namespace

std::vector<ToldTest> read_told(const std::filesystem::path& file) {
    std::ifstream in{file};
    if (!in) {
        throw InputError{fmt::format("there is no {}; build code_mutants with the preset `mutation`", file.string())};
    }
    std::vector<ToldTest> tests;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words{line};
        ToldTest test;
        if (words >> test.name >> test.seconds) {
            for (std::size_t mutant = 0; words >> mutant;) {
                test.mutants.push_back(mutant);
            }
            tests.push_back(std::move(test));
        }
    }
    return tests;
}

std::vector<std::string> filters_by_mutant(const std::vector<ToldTest>& tests, std::size_t count, double budget) {
    std::vector<const ToldTest*> ordered;
    for (const ToldTest& test : tests) {
        ordered.push_back(&test);
    }
    std::sort(ordered.begin(), ordered.end(), [](const ToldTest* a, const ToldTest* b) {
        return std::tie(a->seconds, a->name) < std::tie(b->seconds, b->name);
    });
    std::vector<std::string> filters(count);
    std::vector<double> spent(count);
    for (const ToldTest* test : ordered) {
        for (const std::size_t mutant : test->mutants) {
            if (mutant < count && (filters[mutant].empty() || spent[mutant] + test->seconds <= budget)) {
                filters[mutant] += (filters[mutant].empty() ? "" : ":") + test->name;
                spent[mutant] += test->seconds;
            }
        }
    }
    return filters;
}

std::vector<MutationOutcome> mutate_code(const CodeMutationSetup& setup, const std::vector<AlteredCell>& mutants,
                                         std::size_t count, const std::function<void(std::size_t)>& progress) {
    std::filesystem::create_directories(setup.folder);
    const auto told = setup.folder / "told.tsv";
    if (!run_unaltered(setup.program, setup.folder / "verdicts.xml", {"CANPROOF_TOLD=" + told.string()})) {
        throw InputError{fmt::format("{} fails without any mutant; mend that first", setup.program.string())};
    }
    const auto filters = filters_by_mutant(read_told(told), count, most_seconds);
    return judge_all(
        mutants, {setup.program}, setup.jobs,
        [&](const AlteredCell& mutant, const Servers& servers) {
            const std::string& filter = filters.at(mutant.number);
            MutationOutcome outcome{mutant, "", !filter.empty(), nullptr};
            if (outcome.claimed) {
                outcome.killed_by = servers.front()->run(mutant.number, filter);
            }
            return outcome;
        },
        progress);
}

}  // namespace canproof::host
