// SPDX-License-Identifier: Apache-2.0
#include "host/prove/obligations.hpp"

#include <algorithm>

namespace canproof::host::prove {

std::string name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::proven:
            return "proven";
        case Verdict::refuted:
            return "refuted";
        default:
            return "unknown";
    }
}

void Obligations::add(const std::vector<Term>& path, const Term& holds, const std::string& what,
                      const std::string& where) {
    ++count_;
    const Term plain = holds.simplify();
    if (!is_true(plain)) {
        open_.push_back({path, plain, what, where});
    }
}

Term Obligations::broken(const Obligation& one) const {
    return all_of(context_, one.path) && !one.holds;
}

Obligations::Outcome Obligations::settle(unsigned milliseconds, const std::vector<Term>& preferred) {
    Outcome outcome;
    preferred_ = preferred;
    constexpr std::size_t at_a_time = 32;
    for (std::size_t first = 0; first < open_.size(); first += at_a_time) {
        if (settle_range(first, std::min(first + at_a_time, open_.size()), milliseconds, outcome)) {
            break;
        }
    }
    return outcome;
}

bool Obligations::settle_range(std::size_t first, std::size_t last, unsigned milliseconds, Outcome& outcome) {
    std::vector<Term> some;
    for (std::size_t i = first; i < last; ++i) {
        some.push_back(broken(open_[i]));
    }
    const Answer answer = solver_.satisfiable({any_of(context_, some)}, milliseconds);
    if (answer == Answer::no) {
        return false;
    }
    if (last - first > 1) {
        const std::size_t middle = first + (last - first) / 2;
        return settle_range(first, middle, milliseconds, outcome) || settle_range(middle, last, milliseconds, outcome);
    }
    const Obligation& one = open_[first];
    if (answer == Answer::unknown) {
        if (outcome.verdict == Verdict::proven) {
            outcome.verdict = Verdict::unknown;
            outcome.reason = one.what + " (" + one.where + "): not decided in time";
        }
        return false;
    }
    outcome.verdict = Verdict::refuted;
    outcome.reason = one.what + " (" + one.where + ")";
    outcome.counterexample = solver_.model();
    std::vector<Term> nicer = preferred_;
    nicer.push_back(broken(one));
    if (solver_.satisfiable(nicer, milliseconds) == Answer::yes) {
        outcome.counterexample = solver_.model();
    }
    return true;
}

}  // namespace canproof::host::prove
