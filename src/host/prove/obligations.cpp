// SPDX-License-Identifier: Apache-2.0
#include "host/prove/obligations.hpp"

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

Obligations::Outcome Obligations::settle(unsigned milliseconds, const std::vector<Term>& preferred) {
    Outcome outcome;
    for (const Obligation& one : open_) {
        const Term broken = (!one.holds).simplify();
        const Answer answer = solver_.satisfiable(one.path, broken, milliseconds);
        if (answer == Answer::yes) {
            outcome.verdict = Verdict::refuted;
            outcome.reason = one.what + " (" + one.where + ")";
            outcome.counterexample = solver_.model();
            std::vector<Term> nicer = preferred;
            nicer.insert(nicer.end(), one.path.begin(), one.path.end());
            if (solver_.satisfiable(nicer, broken, milliseconds) == Answer::yes) {
                outcome.counterexample = solver_.model();
            }
            return outcome;
        }
        if (answer == Answer::unknown && outcome.verdict == Verdict::proven) {
            outcome.verdict = Verdict::unknown;
            outcome.reason = one.what + " (" + one.where + "): not decided in time";
        }
    }
    return outcome;
}

}  // namespace canproof::host::prove
