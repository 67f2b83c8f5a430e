// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/kill_judge.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace canproof::host {

namespace {

/// Approximate number of mutants with which a test runs first. They are spread evenly over all mutants of the item.
constexpr std::size_t first_tries = 24;
/// Limit in seconds for the processor time of one test with the altered cells (values in generated tables) of one item.
/// The same limit applies to the test with the mutants of this item's code.
constexpr double most_item_seconds = 3.0;
/// Processor time in seconds that is counted for each start of a test program.
constexpr double start_seconds = 0.1;

const char* const tests_name = "canproof_tests";
const char* const properties_name = "canproof_properties";
const char* const code_name = "code_mutants";

/// Returns the numbers of all mutants in another order: first about `first_tries` numbers that are evenly spread, then
/// the others.
MutantNumbers spread(const MutantNumbers& all) {
    MutantNumbers ordered;
    const std::size_t step = 1 + all.size() / first_tries;
    for (std::size_t first = 0; first < step; ++first) {
        for (std::size_t at = first; at < all.size(); at += step) {
            ordered.push_back(all[at]);
        }
    }
    return ordered;
}

const MutantNumbers* find(const std::map<std::string, MutantNumbers>& all, const std::string& id) {
    const auto found = all.find(id);
    return found == all.end() || found->second.empty() ? nullptr : &found->second;
}

}  // namespace

KillJudge::KillJudge(std::filesystem::path programs, const ItemMutants& mutants,
                     const std::map<std::string, ToldTest>& told)
    : programs_{std::move(programs)},
      tests_{programs_ / tests_name},
      properties_{programs_ / properties_name},
      code_{programs_ / code_name},
      mutants_{mutants},
      told_{told} {}

KillLine KillJudge::judge(const ClaimingTest& test) {
    KillLine line;
    line.body = test.body;
    line.code = test.code;
    noticed_.clear();
    for (const auto& id : test.claims) {
        const MutantNumbers* cells = find(mutants_.cells, id);
        const MutantNumbers* code = find(mutants_.code, id);
        if (cells == nullptr && code == nullptr) {
            line.without_mutants.push_back(id);
        } else if ((cells != nullptr && notices_cell(test, *cells)) || (code != nullptr && notices_code(test, *code))) {
            line.kills.push_back(id);
        }
    }
    return line;
}

double KillJudge::seconds_of(const ClaimingTest& test) const {
    const auto found = told_.find(test.name);
    return found == told_.end() ? 1.0 : std::max(found->second.seconds, 0.01);
}

bool KillJudge::notices_cell(const ClaimingTest& test, const MutantNumbers& cells) {
    TestServer& server = test.is_property ? properties_ : tests_;
    const double seconds = seconds_of(test);
    double left = most_item_seconds;
    for (const std::size_t number : spread(cells)) {
        if (left <= 0.0) {
            break;
        }
        left -= seconds;
        if (!server.run(number, {test.name, seconds}).empty()) {
            return true;
        }
    }
    return notices_at_startup(programs_ / (test.is_property ? properties_name : tests_name), test, cells);
}

bool KillJudge::notices_code(const ClaimingTest& test, const MutantNumbers& code) {
    const auto found = told_.find(test.name);
    MutantNumbers reached;
    if (found != told_.end()) {
        std::set_intersection(code.begin(), code.end(), found->second.mutants.begin(), found->second.mutants.end(),
                              std::back_inserter(reached));
    }
    const double seconds = seconds_of(test);
    double left = most_item_seconds;
    for (const std::size_t number : spread(reached)) {
        auto known = noticed_.find(number);
        if (known == noticed_.end()) {
            if (left <= 0.0) {
                break;
            }
            left -= seconds;
            const bool noticed = !code_.run(number, {test.name, seconds}).empty();
            known = noticed_.emplace(number, noticed).first;
        }
        if (known->second) {
            return true;
        }
    }
    MutantNumbers starting;
    std::copy_if(code.begin(), code.end(), std::back_inserter(starting), [this](std::size_t number) {
        return number < mutants_.at_startup.size() && mutants_.at_startup[number];
    });
    return notices_at_startup(programs_ / code_name, test, starting);
}

/// Returns whether the test notices a mutant in a program that starts with it. A value that the program computes when
/// it starts, such as a table made from constants, changes only in this way.
bool KillJudge::notices_at_startup(const std::filesystem::path& program, const ClaimingTest& test,
                                   const MutantNumbers& numbers) const {
    double left = most_item_seconds;
    for (const std::size_t number : spread(numbers)) {
        if (left <= 0.0) {
            break;
        }
        left -= start_seconds + seconds_of(test);
        if (fails_when_started_altered(program, number, {test.name, seconds_of(test)})) {
            return true;
        }
    }
    return false;
}

}  // namespace canproof::host
