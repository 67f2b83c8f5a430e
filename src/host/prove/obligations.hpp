// SPDX-License-Identifier: Apache-2.0
// Obligations: what must hold on every path. Finds out whether each of them does.
#pragma once

#include <string>
#include <vector>

#include "host/prove/solver.hpp"

namespace canproof::host::prove {

enum class Verdict { proven, refuted, unknown };
std::string name_of(Verdict verdict);

/// An obligation: `holds` must be true wherever all of `path` is true.
struct Obligation {
    std::vector<Term> path;
    Term holds;
    std::string what;
    std::string where;  ///< the function, the file and the line
};

class Obligations {
  public:
    Obligations(z3::context& context, Solver& solver) : context_{context}, solver_{solver} {}

    /// Adds an obligation. An obligation that is true after simplification counts as proven at once.
    void add(const std::vector<Term>& path, const Term& holds, const std::string& what, const std::string& where);
    std::size_t size() const { return count_; }

    struct Outcome {
        Verdict verdict{Verdict::proven};
        std::string reason;  ///< the first obligation that does not hold or could not be decided
        std::optional<z3::model> counterexample;
    };
    /// Decides all obligations. One question to the solver covers several of them and may take `milliseconds`. Where
    /// possible, the counterexample also makes all of `preferred` true.
    Outcome settle(unsigned milliseconds, const std::vector<Term>& preferred);

  private:
    /// Decides the obligations from `first` up to `last`, without `last`. Returns true when one was refuted, which ends
    /// the search.
    bool settle_range(std::size_t first, std::size_t last, unsigned milliseconds, Outcome& outcome);
    Term broken(const Obligation& one) const;

    z3::context& context_;
    Solver& solver_;
    std::vector<Obligation> open_;
    std::vector<Term> preferred_;
    std::size_t count_{0};
};

}  // namespace canproof::host::prove
