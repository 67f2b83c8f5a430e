// SPDX-License-Identifier: Apache-2.0
// Obligations: conditions that must be true on every path. Decides for each obligation whether it is true.
#pragma once

#include <string>
#include <vector>

#include "host/prove/solver.hpp"

namespace canproof::host::prove {

enum class Verdict { proven, refuted, unknown };
std::string name_of(Verdict verdict);

/// An obligation: `holds` must be true whenever all conditions of `path` are true.
struct Obligation {
    std::vector<Term> path;
    Term holds;
    std::string what;
    std::string where;  ///< function, file and line in the source
};

class Obligations {
  public:
    Obligations(z3::context& context, Solver& solver) : context_{context}, solver_{solver} {}

    /// Adds an obligation. If simplification already shows that it is true, it counts as proven and no question is
    /// asked.
    void add(const std::vector<Term>& path, const Term& holds, const std::string& what, const std::string& where);
    std::size_t size() const { return count_; }

    struct Outcome {
        Verdict verdict{Verdict::proven};
        std::string reason;  ///< the refuted obligation; if there is none, the first undecided one
        std::optional<z3::model> counterexample;
    };
    /// Decides all obligations. One question to the solver covers several obligations and may take up to
    /// `milliseconds`. If possible, the counterexample also makes all of `preferred` true.
    Outcome settle(unsigned milliseconds, const std::vector<Term>& preferred);

  private:
    /// Decides the obligations from `first` to `last` - 1. Returns true when one was refuted, which ends the search.
    bool settle_range(std::size_t first, std::size_t last, unsigned milliseconds, Outcome& outcome);
    Term broken(const Obligation& one) const;

    z3::context& context_;
    Solver& solver_;
    std::vector<Obligation> open_;
    std::vector<Term> preferred_;
    std::size_t count_{0};
};

}  // namespace canproof::host::prove
