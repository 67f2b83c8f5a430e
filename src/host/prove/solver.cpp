// SPDX-License-Identifier: Apache-2.0
#include "host/prove/solver.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace canproof::host::prove {

namespace {

constexpr std::size_t most_models = 24;
/// Time in milliseconds for a question to the kept solver, which remembers earlier questions. After this time, a new
/// solver gets the question.
constexpr unsigned kept_milliseconds = 1000;

/// Limits the effort of z3 for the next question. z3 counts its own steps, so the answer does not depend on how busy
/// the machine is.
void limit(z3::solver& solver, unsigned milliseconds) {
    constexpr std::uint64_t steps_in_a_millisecond = 2000;
    const std::uint64_t steps = std::min<std::uint64_t>(std::uint64_t{milliseconds} * steps_in_a_millisecond,
                                                        std::numeric_limits<unsigned>::max());
    z3::params params{solver.ctx()};
    params.set("rlimit", static_cast<unsigned>(steps));
    solver.set(params);
}

}  // namespace

Solver::Solver(z3::context& context) : context_{context}, graph_{context}, kept_{context, z3::solver::simple{}} {}

void Solver::set_defined(Model& model, std::size_t count) const {
    for (; model.keeps_facts && model.defined < count; ++model.defined) {
        const Definition& one = definitions_[model.defined];
        const auto a = model.values.of(one.a);
        const auto b = model.values.of(one.b);
        if (!a || !b) {
            model.keeps_facts = false;
            return;
        }
        const Bits value = one.result(*a, *b);
        if (model.values.of(one.name) != value) {
            model.differing.push_back(model.defined);
            model.values.set(one.name, value);
        }
        if (!model.values.makes_true(one.outline)) {
            throw std::logic_error{"the outline of a definition does not follow from its value"};
        }
    }
}

void Solver::place_bytes(Model& model) const {
    for (; model.keeps_facts && model.placed < bytes_.size(); ++model.placed) {
        const KnownByte& byte = bytes_[model.placed];
        set_defined(model, byte.definitions);
        const auto offset = model.values.of(byte.offset);
        if (!offset) {
            model.keeps_facts = false;
            return;
        }
        const auto [first, is_new] = model.bytes.emplace(std::pair{byte.memory, *offset}, model.placed);
        if (is_new) {
            continue;
        }
        const auto expected = model.values.of(bytes_[first->second].value);
        if (expected != model.values.of(byte.value)) {
            model.clashes.push_back({first->second, model.placed});
            model.values.set(byte.value, *expected);
        }
    }
    set_defined(model, definitions_.size());
}

bool Solver::keeps_facts(Model& model) const {
    place_bytes(model);
    while (model.keeps_facts && model.met < facts_.size()) {
        model.keeps_facts = model.values.makes_true(facts_[model.met]);
        ++model.met;
    }
    return model.keeps_facts;
}

bool Solver::fulfils(Model& model, const std::vector<Term>& truths) const {
    place_bytes(model);
    const auto holds = [&model](const Term& truth) { return model.values.makes_true(truth); };
    return model.keeps_facts && std::all_of(truths.rbegin(), truths.rend(), holds) && keeps_facts(model);
}

std::optional<std::size_t> Solver::model_of(const std::vector<Term>& truths) {
    for (std::size_t i = 0; i < models_.size(); ++i) {
        if (fulfils(models_[i], truths)) {
            return i;
        }
    }
    return std::nullopt;
}

void Solver::use(std::size_t place) {
    std::rotate(models_.begin(), models_.begin() + static_cast<std::ptrdiff_t>(place),
                models_.begin() + static_cast<std::ptrdiff_t>(place) + 1);
}

void Solver::keep(Model model) {
    models_.push_front(std::move(model));
    if (models_.size() > most_models) {
        models_.pop_back();
    }
}

std::vector<Term> Solver::missing_definitions(const Model& model, const std::set<NodeId>& reached) {
    std::vector<Term> missing;
    for (const std::size_t number : model.differing) {
        Definition& one = definitions_[number];
        const unsigned most = detail_ == Detail::outline ? 1 : 2;
        if (one.given < most && reached.count(graph_.node_of(one.name)) != 0) {
            missing.push_back(one.given == 0 ? one.outline : one.fact());
            ++one.given;
        }
    }
    return missing;
}

std::vector<Term> Solver::missing_facts(Model& model, const std::vector<Term>& truths) {
    std::vector<Term> missing;
    for (std::size_t i = 0; i < facts_.size(); ++i) {
        if (!model.values.makes_true(facts_[i]) && is_needed_.insert(i).second) {
            missing.push_back(facts_[i]);
        }
    }
    std::vector<Term> about = truths;
    about.insert(about.end(), needed_.begin(), needed_.end());
    std::set<NodeId> reached;
    for (const Term& one : about) {
        const auto& unknowns = graph_.unknowns_of(one);
        reached.insert(unknowns.begin(), unknowns.end());
    }
    for (const Clash& clash : model.clashes) {
        const KnownByte& first = bytes_[clash.first];
        const KnownByte& second = bytes_[clash.second];
        if (reached.count(graph_.node_of(second.value)) != 0) {
            missing.push_back(z3::implies(first.offset == second.offset, first.value == second.value).simplify());
        }
    }
    const std::vector<Term> definitions = missing_definitions(model, reached);
    missing.insert(missing.end(), definitions.begin(), definitions.end());
    return missing;
}

template <typename Check>
Answer Solver::ask(z3::solver& solver, const std::vector<Term>& truths, const Check& check) {
    for (;;) {
        const z3::check_result answer = check();
        if (answer != z3::sat) {
            return answer == z3::unsat ? Answer::no : Answer::unknown;
        }
        Model model{Assignment{graph_, solver.get_model()}};
        if (fulfils(model, truths)) {
            keep(std::move(model));
            return Answer::yes;
        }
        const std::vector<Term> missing = missing_facts(model, truths);
        if (missing.empty()) {
            return Answer::unknown;
        }
        for (const Term& fact : missing) {
            solver.add(fact);
        }
        needed_.insert(needed_.end(), missing.begin(), missing.end());
    }
}

Term Solver::literal_of(const Term& truth) {
    const auto found = literals_.find(truth.id());
    if (found != literals_.end()) {
        return found->second;
    }
    static_cast<void>(graph_.node_of(truth));  // keeps z3 from giving the number of this term to another term
    const Term literal = context_.bool_const(("t" + std::to_string(literals_.size())).c_str());
    kept_.add(z3::implies(literal, truth));
    literals_.emplace(truth.id(), literal);
    return literal;
}

Answer Solver::ask_kept(const std::vector<Term>& truths, unsigned milliseconds) {
    limit(kept_, milliseconds);
    for (; kept_has_ < needed_.size(); ++kept_has_) {
        kept_.add(needed_[kept_has_]);
    }
    z3::expr_vector literals{context_};
    for (const Term& truth : truths) {
        literals.push_back(literal_of(truth));
    }
    const Answer answer = ask(kept_, truths, [&] { return kept_.check(literals); });
    kept_has_ = needed_.size();
    return answer;
}

Answer Solver::ask_anew(const std::vector<Term>& truths, unsigned milliseconds) {
    z3::solver solver = z3::tactic{context_, "qfbv"}.mk_solver();
    limit(solver, milliseconds);
    for (const Term& fact : needed_) {
        solver.add(fact);
    }
    for (const Term& truth : truths) {
        solver.add(truth);
    }
    return ask(solver, truths, [&] { return solver.check(); });
}

Solver::Slice Solver::slice_of(const std::vector<Term>& path, const Term& condition) {
    std::vector<const Term*> rest;
    for (const Term& one : path) {
        rest.push_back(&one);
    }
    for (const Term& one : needed_) {
        rest.push_back(&one);
    }
    Slice slice{{condition}, graph_.unknowns_of(condition)};
    std::set<NodeId> reached{slice.unknowns.begin(), slice.unknowns.end()};
    for (bool grows = true; grows;) {
        grows = false;
        for (const Term*& one : rest) {
            if (one == nullptr) {
                continue;
            }
            const auto& unknowns = graph_.unknowns_of(*one);
            if (std::none_of(unknowns.begin(), unknowns.end(), [&](NodeId id) { return reached.count(id) != 0; })) {
                continue;
            }
            slice.truths.push_back(*one);
            reached.insert(unknowns.begin(), unknowns.end());
            one = nullptr;
            grows = true;
        }
    }
    slice.unknowns.assign(reached.begin(), reached.end());
    return slice;
}

Answer Solver::ask_slice(const std::vector<Term>& truths, std::size_t model_of_path, unsigned milliseconds) {
    const Slice slice = slice_of({truths.begin(), truths.end() - 1}, truths.back());
    limit(kept_, milliseconds);
    z3::expr_vector literals{context_};
    for (const Term& truth : slice.truths) {
        literals.push_back(literal_of(truth));
    }
    const z3::check_result answer = kept_.check(literals);
    if (answer != z3::sat) {
        return answer == z3::unsat ? Answer::no : Answer::unknown;
    }
    Model both{Assignment{models_[model_of_path].values, kept_.get_model(), slice.unknowns}};
    if (!fulfils(both, truths)) {
        return Answer::unknown;
    }
    keep(std::move(both));
    return Answer::yes;
}

Answer Solver::satisfiable(const std::vector<Term>& path, const Term& condition, unsigned milliseconds, Detail detail) {
    detail_ = detail;
    std::vector<Term> truths = path;
    truths.push_back(condition);
    if (std::any_of(truths.begin(), truths.end(), is_false)) {
        return Answer::no;
    }
    if (const auto place = model_of(truths)) {
        use(*place);
        return Answer::yes;
    }
    ++questions_;
    const unsigned first = std::min(milliseconds, kept_milliseconds);
    Answer answer = Answer::unknown;
    if (const auto place = model_of(path)) {
        answer = ask_slice(truths, *place, first);
    }
    if (answer == Answer::unknown) {
        answer = ask_kept(truths, first);
    }
    return answer == Answer::unknown ? ask_anew(truths, milliseconds) : answer;
}

}  // namespace canproof::host::prove
