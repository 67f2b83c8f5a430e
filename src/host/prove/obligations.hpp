// What must hold on every path, and whether it does.
#pragma once

#include <string>
#include <vector>

#include "host/prove/solver.hpp"

namespace canproof::host::prove {

enum class Verdict { proven, refuted, unknown };
std::string name_of(Verdict verdict);

/// `holds` wherever `path` holds.
struct Obligation {
    std::vector<Term> path;
    Term holds;
    std::string what;
    std::string where;  ///< function, file:line
};

class Obligations {
  public:
    Obligations(z3::context& context, Solver& solver) : context_{context}, solver_{solver} {}

    /// What is plainly true counts as proven at once.
    void add(const std::vector<Term>& path, const Term& holds, const std::string& what, const std::string& where);
    std::size_t size() const { return count_; }

    struct Outcome {
        Verdict verdict{Verdict::proven};
        std::string reason;  ///< the first obligation that does not hold or is not decided
        std::optional<z3::model> counterexample;
    };
    /// Decides all, several at a time, each in at most so long. `preferred` is true of the counterexample where it can
    /// be.
    Outcome settle(unsigned milliseconds, const std::vector<Term>& preferred);

  private:
    /// Those of `first` to `last`; true when the search is over.
    bool settle_range(std::size_t first, std::size_t last, unsigned milliseconds, Outcome& outcome);
    Term broken(const Obligation& one) const;

    z3::context& context_;
    Solver& solver_;
    std::vector<Obligation> open_;
    std::vector<Term> preferred_;
    std::size_t count_{0};
};

}  // namespace canproof::host::prove
