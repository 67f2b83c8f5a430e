// SPDX-License-Identifier: Apache-2.0
// Asks z3 questions and stores answers. The stored answers make most questions unnecessary.
#pragma once

#include <deque>
#include <optional>
#include <set>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

enum class Answer { yes, no, unknown };

class Solver {
  public:
    explicit Solver(z3::context& context) : context_{context} {}

    /// Adds a fact that every later question assumes. z3 gets a fact only when a model of z3 contradicts it: of
    /// thousands of facts, z3 gets few. This is sound: what is impossible without a fact is also impossible with it,
    /// and a model counts only if it contradicts no fact.
    void know(const Term& fact) { facts_.push_back(fact); }
    /// Returns whether all conditions in `truths` can be true at the same time. Returns `unknown` when z3 needs more
    /// than `milliseconds`.
    Answer satisfiable(const std::vector<Term>& truths, unsigned milliseconds);
    /// Returns values that satisfy the last question with the answer `yes`.
    const z3::model& model() const { return models_.front().values; }
    std::size_t questions() const { return questions_; }

  private:
    /// The values of an earlier answer. They satisfy the first `met` facts.
    struct Model {
        z3::model values;
        std::size_t met{0};
        bool keeps_facts{true};
    };

    /// Returns whether a stored model makes all of `truths` and all facts true. Then z3 need not be asked.
    bool known_to_hold(const std::vector<Term>& truths);
    /// Checks the facts that were added after the model was last checked. Returns false when the model contradicts one
    /// of them.
    bool keeps_facts(Model& model) const;
    /// Returns the numbers of the facts that are not true with these values.
    std::vector<std::size_t> broken_facts(const z3::model& values) const;

    z3::context& context_;
    std::vector<Term> facts_;
    std::set<std::size_t> needed_;  ///< numbers of the facts that z3 gets
    std::deque<Model> models_;      ///< the model that was used last comes first
    std::size_t questions_{0};
};

}  // namespace canproof::host::prove
