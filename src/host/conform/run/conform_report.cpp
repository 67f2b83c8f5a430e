// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/conform_report.hpp"

#include <algorithm>

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

std::optional<double> ConformReport::load_of(std::uint64_t bits, double during) const {
    if (bit_rate == 0 || time.us == 0) {
        return std::nullopt;
    }
    return 100.0 * static_cast<double>(bits) / (static_cast<double>(bit_rate) * during);
}

std::optional<double> ConformReport::mean_load() const {
    return load_of(bus_use.bits(), seconds());
}

/// Returns the highest load, limited to 100 %. All bits of a frame count in the second in which the frame ends, even if
/// it began earlier, so a full bus could give slightly more than 100 %.
std::optional<double> ConformReport::highest_load() const {
    const auto load = load_of(bus_use.busiest_second(), std::min(seconds(), 1.0));
    return load ? std::optional{std::min(*load, 100.0)} : std::nullopt;
}

int ConformReport::exit_status() const {
    if (interrupted || count(Verdict::broken) != 0 || results.empty()) {
        return 2;
    }
    const bool fails = count(Verdict::failed) + count(Verdict::unstable) + count(Verdict::no_answer) != 0;
    return fails || !left.empty() ? 1 : 0;
}

}  // namespace canproof::host::conform
