// SPDX-License-Identifier: Apache-2.0
#include "host/prove/solver.hpp"

#include <algorithm>

namespace canproof::host::prove {

namespace {

constexpr std::size_t most_models = 6;

}  // namespace

bool Solver::known_to_hold(const std::vector<Term>& truths) {
    for (std::size_t i = 0; i < models_.size(); ++i) {
        const z3::model& one = models_[i];
        const auto holds = [&one](const Term& truth) { return is_true(one.eval(truth, true)); };
        if (std::all_of(truths.rbegin(), truths.rend(), holds) && std::all_of(facts_.begin(), facts_.end(), holds)) {
            std::rotate(models_.begin(), models_.begin() + static_cast<std::ptrdiff_t>(i),
                        models_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            return true;
        }
    }
    return false;
}

Answer Solver::satisfiable(const std::vector<Term>& truths, unsigned milliseconds) {
    if (std::any_of(truths.begin(), truths.end(), is_false)) {
        return Answer::no;
    }
    if (known_to_hold(truths)) {
        return Answer::yes;
    }
    ++questions_;
    z3::solver solver = z3::tactic{context_, "qfbv"}.mk_solver();
    z3::params params{context_};
    params.set("timeout", milliseconds);
    solver.set(params);
    const auto add = [&solver](const Term& one) { solver.add(one); };
    std::for_each(facts_.begin(), facts_.end(), add);
    std::for_each(truths.begin(), truths.end(), add);
    switch (solver.check()) {
        case z3::unsat:
            return Answer::no;
        case z3::sat:
            break;
        default:
            return Answer::unknown;
    }
    models_.push_front(solver.get_model());
    if (models_.size() > most_models) {
        models_.pop_back();
    }
    return Answer::yes;
}

}  // namespace canproof::host::prove
