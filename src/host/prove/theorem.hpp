// One theorem: what it says, and what came of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/prove/program.hpp"
#include "host/prove/proof.hpp"

namespace canproof::host::prove {

/// What a theorem left open, as it is in a counterexample: a byte each; -1 where the value stays.
using InputBytes = std::vector<int>;

struct TheoremResult {
    std::string name;
    std::string file;  ///< of the harness
    std::string area;  ///< its folder
    std::string statement{};
    std::vector<std::string> requirements{};
    Verdict verdict{Verdict::unknown};
    std::string reason{};                    ///< the obligation that fails or is open; why nothing is known
    std::vector<std::string> functions{};    ///< of the firmware, that were executed
    std::vector<std::string> assumptions{};  ///< what the harness assumes, each with its place
    double paths{0.0};
    std::size_t obligations{0};
    std::size_t questions{0};  ///< to z3
    double seconds{0.0};
    std::vector<InputBytes> inputs{};  ///< of the counterexample, in the order in which the harness asks
    std::string replay{};              ///< what the native program does with them
};

/// Executes the theorem and decides its obligations. A theorem that no path comes to the end of is refuted: its
/// assumptions contradict each other. `noted` is called when `result` knows what the theorem says.
void decide(const Program& program, const Limits& limits, TheoremResult& result, const std::function<void()>& noted);

}  // namespace canproof::host::prove
