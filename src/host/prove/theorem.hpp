// SPDX-License-Identifier: Apache-2.0
// One theorem: what it says, and its result.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/prove/program.hpp"
#include "host/prove/proof.hpp"

namespace canproof::host::prove {

/// One value that a theorem left open, as in the counterexample: a number for each byte, and -1 for a byte that keeps
/// its value.
using InputBytes = std::vector<int>;

struct TheoremResult {
    std::string name;
    std::string file;  ///< the file of the harness
    std::string area;  ///< the name of the folder of that file
    std::string statement{};
    std::vector<std::string> requirements{};
    Verdict verdict{Verdict::unknown};
    std::string reason{};                    ///< the obligation that fails or is open; why nothing is known
    std::vector<std::string> functions{};    ///< executed functions of the firmware
    std::vector<std::string> assumptions{};  ///< assumptions of the harness, each with its place
    double paths{0.0};
    std::size_t obligations{0};
    std::size_t questions{0};  ///< number of questions to z3
    double seconds{0.0};
    std::vector<InputBytes>
        inputs{};          ///< inputs of the counterexample, in the order in which the harness asks for them
    std::string replay{};  ///< result of the native program with these inputs
};

/// Executes the theorem and decides its obligations, case by case (each()). A theorem whose end no path reaches is
/// refuted: its assumptions contradict each other. `noted` is called whenever the statement or the requirements in
/// `result` have changed.
void decide(const Program& program, const Limits& limits, TheoremResult& result, const std::function<void()>& noted);

}  // namespace canproof::host::prove
