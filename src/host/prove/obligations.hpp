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
    explicit Obligations(Solver& solver) : solver_{solver} {}

    /// Adds an obligation. If simplification already shows that it is true, it counts as proven, and the solver is not
    /// asked.
    void add(const std::vector<Term>& path, const Term& holds, const std::string& what, const std::string& where);
    std::size_t size() const { return count_; }

    struct Outcome {
        Verdict verdict{Verdict::proven};
        std::string reason;  ///< the refuted obligation; if there is none, the first undecided one
        std::optional<Assignment> counterexample;
    };
    /// Decides all obligations, until one is refuted. A question to the solver may take up to `milliseconds`. If
    /// possible, the counterexample also makes all of `preferred` true.
    Outcome settle(unsigned milliseconds, const std::vector<Term>& preferred);

  private:
    Solver& solver_;
    std::vector<Obligation> open_;
    std::size_t count_{0};
};

}  // namespace canproof::host::prove
