// SPDX-License-Identifier: Apache-2.0
// The state of the proof of one theorem.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "host/prove/case.hpp"
#include "host/prove/floats.hpp"
#include "host/prove/layered_contents.hpp"
#include "host/prove/memory.hpp"
#include "host/prove/obligations.hpp"
#include "host/prove/solver.hpp"

namespace canproof::host::prove {

/// Limits of a proof's resources. A theorem that needs more has the verdict `unknown`.
struct Limits {
    /// time in seconds for one question about obligations; ProveOptions::seconds usually ends the proof earlier
    unsigned seconds{3600};
    /// time in milliseconds for the question whether a branch can be taken; without an answer in time, the branch
    /// counts as possible
    unsigned branch_milliseconds{1000};
    unsigned loop_milliseconds{20000};  ///< the same limit as `branch_milliseconds`, from the second pass of a loop on
    unsigned visits{2000};              ///< greatest number of executions of one block in one call
    unsigned depth{64};                 ///< greatest number of nested calls
};

/// One value, object or memory that may have any value, because the harness asked for it. `bytes` are in the order in
/// which the harness asked for them. A byte that is part of an address keeps its value and has no term here.
struct Input {
    std::vector<std::optional<Term>> bytes;
    std::optional<Term> size{};  ///< size of the memory that any_memory() made; otherwise empty
    /// memory that any_memory() made, with its bytes that were read so far; otherwise empty
    std::shared_ptr<const UnknownBytes> memory{};
};

/// An invariant that the harness states for the loop of a function. Terms are addresses, or numbers of 64 bits.
struct LoopRule {
    std::string function;                ///< name of the function, without parameters
    std::uint64_t number;                ///< of the function's outermost loops, in the order of the source
    std::vector<std::string> variables;  ///< local variables that the invariant is about, at most two
    Term most;                           ///< greatest number of passes of the loop
    Term changed;                        ///< address of the bytes that the loop changes
    std::uint64_t bytes;                 ///< number of these bytes; 0 when the loop changes no memory of its caller
    Term holds;                          ///< address of the function that states the invariant
    Term context;                        ///< its first argument
};

/// A function of the harness that is executed in place of a function of the firmware.
struct Contract {
    std::string function;  ///< name of the function of the firmware, without parameters
    std::string theorem;   ///< name of the theorem that proves the contract
    Term stands_for;       ///< address of the function of the harness
};

/// Key of a stored answer of reach_of(), which returns the bytes that an access may reach. The key contains the nodes
/// of a place's condition, of its offset and of the number of bytes, then the nodes of the path's conditions.
using ReachKey = std::vector<NodeId>;

struct Proof {
    Proof(const Limits& bounds, Case& chosen) : limits{bounds}, at{chosen} {}

    /// Makes a new unknown value with `width` bits.
    Term fresh(unsigned width) { return context.bv_const(("v" + std::to_string(unknowns++)).c_str(), width); }

    Limits limits;
    Case& at;
    std::size_t each_calls{0};  ///< number of calls of each() so far
    z3::context context{};
    Solver solver{context};
    Floats floats{solver, [this](unsigned width) { return fresh(width); }};
    Objects objects{};
    Obligations obligations{solver};
    std::size_t unknowns{0};
    std::map<ReachKey, Reach> reaches{};  ///< the answers of reach_of() so far
    std::vector<Input> inputs{};
    std::deque<LoopRule> loop_rules{};  ///< in the order in which the harness stated them
    std::deque<Contract> contracts{};
    bool is_modular{false};  ///< whether a loop was executed once, for any pass, or a contract in place of a function
    std::set<std::string> used_theorems{};  ///< names of the theorems that prove the contracts that were used
    std::set<unsigned> state_bytes{};  ///< ids of the terms for bytes for which leave_state_open() allows any value
    std::string statement{};           ///< statement of the theorem, as the harness gives it
    std::vector<std::string> requirements{};  ///< requirements that the harness names
    std::function<void()> noted{};            ///< called after each change of `statement` or `requirements`
    std::set<std::string> assumptions{};      ///< place of each assumption, as `file:line`
    std::set<std::string> functions{};        ///< functions of the firmware that were executed
};

}  // namespace canproof::host::prove
