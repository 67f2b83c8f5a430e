// Questions to z3, and a memory of answers that saves most of them.
#pragma once

#include <deque>
#include <optional>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

enum class Answer { yes, no, unknown };

class Solver {
  public:
    explicit Solver(z3::context& context) : context_{context} {}

    /// Holds from now on, in every question.
    void know(const Term& fact) { facts_.push_back(fact); }
    /// Whether all of these can be true at once. `unknown` when that takes longer.
    Answer satisfiable(const std::vector<Term>& truths, unsigned milliseconds);
    /// Values for which the last question that was answered with `yes` holds.
    const z3::model& model() const { return models_.front(); }
    std::size_t questions() const { return questions_; }

  private:
    /// Whether one of the last models makes them true.
    bool known_to_hold(const std::vector<Term>& truths);

    z3::context& context_;
    std::vector<Term> facts_;
    std::deque<z3::model> models_;  ///< newest first
    std::size_t questions_{0};
};

}  // namespace canproof::host::prove
