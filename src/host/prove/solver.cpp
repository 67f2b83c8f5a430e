// SPDX-License-Identifier: Apache-2.0
#include "host/prove/solver.hpp"

#include <algorithm>

namespace canproof::host::prove {

namespace {

constexpr std::size_t most_models = 6;

}  // namespace

bool Solver::keeps_facts(Model& model) const {
    while (model.keeps_facts && model.met < facts_.size()) {
        model.keeps_facts = is_true(model.values.eval(facts_[model.met], true));
        ++model.met;
    }
    return model.keeps_facts;
}

bool Solver::known_to_hold(const std::vector<Term>& truths) {
    for (std::size_t i = 0; i < models_.size(); ++i) {
        Model& one = models_[i];
        const auto holds = [&one](const Term& truth) { return is_true(one.values.eval(truth, true)); };
        if (std::all_of(truths.rbegin(), truths.rend(), holds) && keeps_facts(one)) {
            std::rotate(models_.begin(), models_.begin() + static_cast<std::ptrdiff_t>(i),
                        models_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            return true;
        }
    }
    return false;
}

std::vector<std::size_t> Solver::broken_facts(const z3::model& values) const {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < facts_.size(); ++i) {
        if (!is_true(values.eval(facts_[i], true))) {
            broken.push_back(i);
        }
    }
    return broken;
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
    for (const std::size_t fact : needed_) {
        solver.add(facts_[fact]);
    }
    for (const Term& truth : truths) {
        solver.add(truth);
    }
    for (;;) {
        const z3::check_result answer = solver.check();
        if (answer != z3::sat) {
            return answer == z3::unsat ? Answer::no : Answer::unknown;
        }
        const z3::model values = solver.get_model();
        const std::vector<std::size_t> broken = broken_facts(values);
        if (broken.empty()) {
            models_.push_front({values, facts_.size(), true});
            break;
        }
        for (const std::size_t fact : broken) {
            needed_.insert(fact);
            solver.add(facts_[fact]);
        }
    }
    if (models_.size() > most_models) {
        models_.pop_back();
    }
    return Answer::yes;
}

}  // namespace canproof::host::prove
