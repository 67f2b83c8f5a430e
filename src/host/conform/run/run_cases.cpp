// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/run_cases.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"
#include "host/conform/run/case_runner.hpp"

namespace canproof::host::conform {

namespace {

bool has(const std::vector<std::string>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

/// Returns whether the list contains the id of the case or one of its numbers.
bool names(const std::vector<std::string>& all, const Case& one) {
    return has(all, one.id) || std::any_of(one.numbers.begin(), one.numbers.end(),
                                           [&](const std::string& number) { return has(all, number); });
}

void check_names(const std::vector<std::string>& all, const CaseBook& book, bool groups) {
    for (const std::string& name : all) {
        const bool known =
            (groups && has(case_groups(), name)) ||
            std::any_of(book.cases.begin(), book.cases.end(), [&](const Case& one) { return names({name}, one); });
        if (!known) {
            throw InputError{fmt::format("there is no case {}; `canproof conform --list` lists the cases", name)};
        }
    }
}

CaseResult not_run(const Case& one, const std::string& why) {
    CaseResult result = result_of(one);
    result.why = why;
    return result;
}

}  // namespace

std::vector<const Case*> chosen_cases(const CaseBook& book, const ConformOptions& options) {
    for (const std::string& group : options.only) {
        if (!has(case_groups(), group)) {
            throw InputError{
                fmt::format("there is no service {}; `canproof conform --list` lists the services", group)};
        }
    }
    check_names(options.cases, book, false);
    check_names(options.skip, book, true);
    std::vector<const Case*> chosen;
    for (const Case& one : book.cases) {
        const bool wanted = (options.only.empty() || has(options.only, one.group)) &&
                            (options.cases.empty() || names(options.cases, one));
        if (wanted && !has(options.skip, one.group) && !names(options.skip, one)) {
            chosen.push_back(&one);
        }
    }
    return chosen;
}

ConformReport run_cases(const CaseBook& book, const ConformSheet& sheet, Target& target,
                        const ConformOptions& options) {
    const std::vector<const Case*> chosen = chosen_cases(book, options);
    ConformReport report;
    report.sheet = sheet.name;
    report.checksum = sheet.checksum;
    report.sheet_notes = sheet.notes;
    report.target = target.name();
    report.node = sheet.node_id;
    report.traffic = options.traffic;
    CaseRunner runner{book, sheet, target, options};
    const Instant start = target.now();
    std::string ended;
    try {
        runner.begin(report);
        report.bit_rate = target.bit_rate();
        for (const Case* const one : chosen) {
            report.results.push_back(ended.empty() ? runner.run(*one) : not_run(*one, ended));
            const CaseResult& result = report.results.back();
            if (options.progress) {
                options.progress(result);
            }
            if (ended.empty() && !runner.is_alive()) {
                ended = fmt::format("the slave stopped answering in the case {}", result.id);
            }
            const bool failed = result.verdict == Verdict::failed || result.verdict == Verdict::no_answer;
            if (options.first_failure_ends && failed) {
                break;
            }
        }
    } catch (const Interrupted&) {
        report.interrupted = true;
        while (report.results.size() < chosen.size()) {
            report.results.push_back(not_run(*chosen[report.results.size()], "the run was interrupted"));
        }
    }
    if (report.interrupted || !target.is_repeatable()) {
        report.left = runner.put_everything_back();
    }
    report.time = elapsed(start, target.now());
    report.bus_use = runner.bus_use();
    const BusReport bus = target.report();
    report.error_frames = bus.errors;
    report.lost_frames = bus.lost;
    return report;
}

}  // namespace canproof::host::conform
