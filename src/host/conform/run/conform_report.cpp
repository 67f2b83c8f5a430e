// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

const char* words_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "passed";
        case Verdict::failed:
            return "failed";
        case Verdict::unstable:
            return "unstable";
        case Verdict::skipped:
            return "skipped";
        case Verdict::no_answer:
            return "no answer";
        case Verdict::broken:
            return "broken";
        case Verdict::not_run:
            break;
    }
    return "not run";
}

CaseResult result_of(const Case& one) {
    CaseResult result;
    result.id = one.id;
    result.group = one.group;
    result.numbers = one.numbers;
    result.shows = one.shows;
    result.section = one.section;
    result.tests = one.tests;
    return result;
}

std::optional<double> ConformReport::mean_load() const {
    if (bit_rate == 0 || time.us == 0) {
        return std::nullopt;
    }
    const double seconds = static_cast<double>(time.us) / 1.0e6;
    return 100.0 * static_cast<double>(bus_use.bits()) / (static_cast<double>(bit_rate) * seconds);
}

std::optional<double> ConformReport::highest_load() const {
    if (bit_rate == 0) {
        return std::nullopt;
    }
    return 100.0 * static_cast<double>(bus_use.busiest_second()) / static_cast<double>(bit_rate);
}

int ConformReport::exit_status() const {
    if (interrupted || count(Verdict::broken) != 0 || results.empty()) {
        return 2;
    }
    const bool fails = count(Verdict::failed) + count(Verdict::unstable) + count(Verdict::no_answer) != 0;
    return fails || !left.empty() ? 1 : 0;
}

}  // namespace canproof::host::conform
