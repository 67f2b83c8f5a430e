// SPDX-License-Identifier: Apache-2.0
// Everything that belongs to the proof of one theorem.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "host/prove/case.hpp"
#include "host/prove/layered_contents.hpp"
#include "host/prove/memory.hpp"
#include "host/prove/obligations.hpp"
#include "host/prove/solver.hpp"

namespace canproof::host::prove {

/// The resources that a proof may use. A theorem that exceeds one of them is unknown.
struct Limits {
    unsigned seconds{3600};              ///< for one question about obligations; the bound of processor time
                                         ///< (ProveOptions::seconds) is usually reached before
    unsigned branch_milliseconds{1000};  ///< for the question whether a branch can be taken; it counts as possible then
    unsigned loop_milliseconds{20000};   ///< for that question from the second pass of a loop on
    unsigned visits{2000};               ///< of one block in one call: bounds the passes of loops
    unsigned depth{64};                  ///< of calls inside calls
};

/// One value, object or memory that the harness leaves open: its bytes in the order in which the harness asked for
/// them. In an object left open, a byte that is part of an address keeps its value and has no term here.
struct Input {
    std::vector<std::optional<Term>> bytes;
    std::optional<Term> size{};                    ///< only for any_memory(): its size
    std::shared_ptr<const UnknownBytes> memory{};  ///< only for any_memory(): its bytes that were read
};

struct Proof {
    Proof(const Limits& bounds, Case& chosen) : limits{bounds}, at{chosen} {}

    /// Makes a new unknown value with `width` bits.
    Term fresh(unsigned width) { return context.bv_const(("v" + std::to_string(unknowns++)).c_str(), width); }

    Limits limits;
    Case& at;
    std::size_t each_calls{0};  ///< calls of each() so far
    z3::context context{};
    Solver solver{context};
    Objects objects{};
    Obligations obligations{context, solver};
    std::size_t unknowns{0};
    std::vector<Input> inputs{};
    std::set<unsigned> state_bytes{};         ///< bytes of open states, by number of the term
    std::string statement{};                  ///< the statement of the harness
    std::vector<std::string> requirements{};  ///< requirements that the harness names
    std::function<void()> noted{};            ///< called after each change of the statement or the requirements
    std::set<std::string> assumptions{};      ///< `file:line` of each
    std::set<std::string> functions{};        ///< executed functions of the firmware
};

}  // namespace canproof::host::prove
