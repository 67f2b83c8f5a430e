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

int ConformReport::exit_status() const {
    if (interrupted || count(Verdict::broken) != 0 || results.empty()) {
        return 2;
    }
    const bool fails = count(Verdict::failed) + count(Verdict::unstable) + count(Verdict::no_answer) != 0;
    return fails || !left.empty() ? 1 : 0;
}

}  // namespace canproof::host::conform
