// Everything that belongs to the proof of one theorem.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "host/prove/layered_contents.hpp"
#include "host/prove/memory.hpp"
#include "host/prove/obligations.hpp"
#include "host/prove/solver.hpp"

namespace canproof::host::prove {

/// What a proof may take before the theorem is unknown.
struct Limits {
    unsigned seconds{3600};               ///< for one obligation; the bound of processor time comes first
    unsigned branch_milliseconds{20000};  ///< for the question whether a branch can be taken
    unsigned visits{2000};                ///< of one block in one call: the bound of loops
    unsigned depth{64};                   ///< of calls
};

/// Something that the harness leaves open: the bytes in the order in which it asked. A byte of a state that is part of
/// an address keeps its value and has no term.
struct Input {
    std::vector<std::optional<Term>> bytes;
    std::optional<Term> size{};                    ///< of memory of any size
    std::shared_ptr<const UnknownBytes> memory{};  ///< what was read of it
};

struct Proof {
    explicit Proof(const Limits& bounds) : limits{bounds} {}

    /// An unknown of a width.
    Term fresh(unsigned width) { return context.bv_const(("v" + std::to_string(unknowns++)).c_str(), width); }

    Limits limits;
    z3::context context{};
    Solver solver{context};
    Objects objects{};
    Obligations obligations{context, solver};
    std::size_t unknowns{0};
    std::vector<Input> inputs{};
    std::set<unsigned> state_bytes{};         ///< of open states, by number of the term
    std::string statement{};                  ///< what the harness says that it shows
    std::vector<std::string> requirements{};  ///< that it names
    std::function<void()> noted{};            ///< after each of both
    std::set<std::string> assumptions{};      ///< `file:line` of each
    std::set<std::string> functions{};        ///< of the firmware, that were executed
};

}  // namespace canproof::host::prove
