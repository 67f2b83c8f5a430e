// SPDX-License-Identifier: Apache-2.0
// Asks z3 questions, and remembers some answers, which saves most of the questions.
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

    /// Adds a fact, which every later question takes as true. A fact goes to z3 once values were found that break it:
    /// most of thousands never do, and no such values without a fact are none with it.
    void know(const Term& fact) { facts_.push_back(fact); }
    /// Returns whether all of these can be true at the same time. Returns `unknown` when z3 needs more than
    /// `milliseconds` to decide it.
    Answer satisfiable(const std::vector<Term>& truths, unsigned milliseconds);
    /// Values that make the last question true that was answered with `yes`.
    const z3::model& model() const { return models_.front().values; }
    std::size_t questions() const { return questions_; }

  private:
    /// Values of an earlier answer. The first `met` facts are true with them.
    struct Model {
        z3::model values;
        std::size_t met{0};
        bool keeps_facts{true};
    };

    /// True when one of the last models makes all of these, and all facts, true; z3 need not be asked then.
    bool known_to_hold(const std::vector<Term>& truths);
    /// Checks the facts that are new to a model. False when one is not true with it.
    bool keeps_facts(Model& model) const;
    /// Returns the numbers of the facts that values break.
    std::vector<std::size_t> broken_facts(const z3::model& values) const;

    z3::context& context_;
    std::vector<Term> facts_;
    std::set<std::size_t> needed_;  ///< numbers of the facts that z3 gets
    std::deque<Model> models_;      ///< the one used last comes first
    std::size_t questions_{0};
};

}  // namespace canproof::host::prove
