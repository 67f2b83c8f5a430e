// SPDX-License-Identifier: Apache-2.0
// Tests that a conformance case notices each deliberate fault (a case of the service that has the fault), and that no
// case fails on a correct slave. Normally, the cases of the service with the fault run until one fails, and each run
// under bus load uses a part of the cases. With CANPROOF_ZOO=all, every case runs on every fault, and all cases run a
// hundred times under bus load; this takes some minutes. CANPROOF_ZOO_SEED=N changes the seed of the random load.
// CANPROOF_ZOO_FAULT=ID runs all cases on one fault and prints their results.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "host/base/input_error.hpp"
#include "host/conform/run/run_cases.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/loaded_target.hpp"
#include "tests/conformance/zoo/wrong_slave.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::test::zoo {

namespace {

namespace conform = host::conform;

using conform::CaseResult;
using conform::ConformOptions;
using conform::ConformReport;
using conform::Verdict;

constexpr std::uint8_t node = 5;
constexpr std::size_t runs_under_load = 100;
constexpr double least_detected = 0.95;

std::string wish(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? "" : text;
}

bool runs_all() {
    return wish("CANPROOF_ZOO") == "all";
}

const conform::ConformSheet& sheet() {
    static const conform::ConformSheet read = conform::sheet_of(slave_part());
    return read;
}

bool is_failure(const CaseResult& one) {
    return one.verdict == Verdict::failed || one.verdict == Verdict::no_answer || one.verdict == Verdict::broken;
}

std::string words_of(const CaseResult& one) {
    return fmt::format("{} ({}): {}: {} [{}]", one.id, one.group, conform::words_of(one.verdict), one.why, one.step);
}

ConformReport run_on(const Distortion& distortion, const ConformOptions& options) {
    conform::VirtualTarget target{std::make_unique<WrongSlave>(distortion), node};
    return conform::run_cases(conform::built_in_cases(), sheet(), target, options);
}

/// The conformance cases that fail on a slave with a fault.
struct Catch {
    std::vector<std::string> of_service;  ///< failed cases of the service that has the fault
    std::vector<std::string> others;      ///< failed cases of other services
    std::string words;
};

Catch catch_fault(const Fault& fault, bool all_cases) {
    ConformOptions options;
    if (!all_cases) {
        options.only = {fault.service};
        options.first_failure_ends = true;
    }
    Catch caught;
    try {
        for (const CaseResult& one : run_on(fault.distortion, options).results) {
            if (is_failure(one)) {
                (one.group == fault.service ? caught.of_service : caught.others).push_back(one.id);
                caught.words += "  " + words_of(one) + "\n";
            }
        }
    } catch (const host::InputError& error) {
        caught.words = fmt::format("  no run at all: {}\n", error.what());
    }
    return caught;
}

/// Returns all faults, or only the fault that CANPROOF_ZOO_FAULT names.
Faults chosen_faults(const Faults& all) {
    Faults chosen;
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [](const Fault& one) {
        return wish("CANPROOF_ZOO_FAULT").empty() || one.id == wish("CANPROOF_ZOO_FAULT");
    });
    return chosen;
}

/// Returns the seed of the first run: CANPROOF_ZOO_SEED, or 0 without it.
std::uint64_t first_seed() {
    return wish("CANPROOF_ZOO_SEED").empty() ? 0 : std::stoull(wish("CANPROOF_ZOO_SEED"));
}

/// Returns the ids of the cases of a run: all with CANPROOF_ZOO=all, otherwise every 40th case, beginning at a position
/// that depends on `run`. Leaves out cases that load the bus themselves: with the additional load, the bus could not
/// carry all frames.
std::vector<std::string> cases_of_run(std::size_t run) {
    const std::size_t parts = runs_all() ? 1 : 40;
    std::vector<std::string> ids;
    const auto& cases = conform::built_in_cases().cases;
    for (std::size_t at = run % parts; at < cases.size(); at += parts) {
        if (cases[at].group != "load") {
            ids.push_back(cases[at].id);
        }
    }
    return ids;
}

class UnderRandomLoad : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST(FaultySlaves, NoConformanceCaseFailsOnTheCorrectSlave) {
    const ConformReport report = run_on({}, {});
    for (const CaseResult& one : report.results) {
        EXPECT_FALSE(is_failure(one)) << words_of(one);
        EXPECT_TRUE(one.left.empty()) << one.id << ": not put back: " << fmt::format("{}", fmt::join(one.left, "; "));
    }
    EXPECT_GT(report.count(Verdict::passed), 100U);
}

TEST_P(UnderRandomLoad, NoConformanceCaseFailsOnTheCorrectSlaveUnderRandomBusLoad) {
    const std::size_t run = GetParam();
    const std::uint64_t seed = first_seed() + run;
    std::mt19937_64 generator{seed};
    const double load = 0.05 + 0.0055 * static_cast<double>(generator() % 100U);  // 5 to 60 %
    LoadedTarget target{std::make_unique<WrongSlave>(), node, load, generator()};
    ConformOptions options;
    options.cases = cases_of_run(run);
    for (const CaseResult& one : conform::run_cases(conform::built_in_cases(), sheet(), target, options).results) {
        EXPECT_FALSE(is_failure(one)) << "seed " << seed << ", load " << load << ": " << words_of(one);
    }
}

INSTANTIATE_TEST_SUITE_P(Run, UnderRandomLoad, testing::Range<std::size_t>(0, runs_under_load));

TEST(FaultySlaves, ConformanceCasesNoticeAtLeast95PercentOfTheFaultsOfTheirService) {
    const Faults faults = chosen_faults(all_faults());
    const bool all_cases = runs_all() || faults.size() == 1;
    std::size_t caught = 0;
    std::string missed;
    for (const Fault& fault : faults) {
        const Catch found = catch_fault(fault, all_cases);
        fmt::print("{:<32} {:<10} {} | {}\n{}", fault.id, fault.service, fmt::join(found.of_service, " "),
                   fmt::join(found.others, " "), faults.size() == 1 ? found.words : "");
        if (found.of_service.empty()) {
            missed += fmt::format("  {} ({}): {}\n{}", fault.id, fault.service, fault.what, found.words);
        } else {
            ++caught;
        }
    }
    fmt::print("{} of {} faults are noticed by a case of their service; not noticed:\n{}", caught, faults.size(),
               missed);
    ASSERT_FALSE(faults.empty()) << "there is no fault of that name";
    EXPECT_GE(static_cast<double>(caught), least_detected * static_cast<double>(faults.size())) << missed;
}

}  // namespace canproof::test::zoo
