// SPDX-License-Identifier: Apache-2.0
// Asks z3 questions, and remembers some answers, which saves most of the questions.
#pragma once

#include <deque>
#include <optional>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

enum class Answer { yes, no, unknown };

class Solver {
  public:
    explicit Solver(z3::context& context) : context_{context} {}

    /// Adds a fact, which every later question takes as true.
    void know(const Term& fact) { facts_.push_back(fact); }
    /// Returns whether all of these can be true at the same time. Returns `unknown` when z3 needs more than
    /// `milliseconds` to decide it.
    Answer satisfiable(const std::vector<Term>& truths, unsigned milliseconds);
    /// Returns values for which the last question with the answer `yes` is true.
    const z3::model& model() const { return models_.front(); }
    std::size_t questions() const { return questions_; }

  private:
    /// Returns whether one of the last models makes all of these, and all facts, true. Then z3 does not have to be
    /// asked.
    bool known_to_hold(const std::vector<Term>& truths);

    z3::context& context_;
    std::vector<Term> facts_;
    std::deque<z3::model> models_;  ///< the one used last comes first
    std::size_t questions_{0};
};

}  // namespace canproof::host::prove
