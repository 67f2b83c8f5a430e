// SPDX-License-Identifier: Apache-2.0
// One theorem: its statement and its result.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/prove/program.hpp"
#include "host/prove/proof.hpp"

namespace canproof::host::prove {

/// The bytes that a counterexample gives to one value of the theorem. -1 stands for a byte that keeps its value because
/// it is part of an address.
using InputBytes = std::vector<int>;

struct TheoremResult {
    std::string name;
    std::string file;  ///< path of the harness
    std::string area;  ///< name of the folder that contains the harness
    std::string statement{};
    std::vector<std::string> requirements{};
    Verdict verdict{Verdict::unknown};
    std::string reason{};  ///< the obligation that is refuted or undecided, or the reason why nothing was decided
    std::vector<std::string> functions{};      ///< functions of the firmware that were executed
    std::vector<std::string> assumptions{};    ///< assumptions of the harness, each with its place
    std::vector<std::string> used_theorems{};  ///< theorems that prove the contracts which this theorem uses
    double paths{0.0};
    std::size_t obligations{0};
    std::size_t questions{0};  ///< number of questions to z3
    double seconds{0.0};
    std::vector<InputBytes>
        inputs{};               ///< values of the counterexample, in the order in which the harness asks for them
    bool is_kept{false};        ///< whether this is the result of an earlier run with the same code
    bool rests_on_base{false};  ///< kept, although functions of src/firmware/base changed: their theorems are proven
    std::string replay{};       ///< result of the native program with these values
};

/// Executes the theorem and decides its obligations, one case after the other (each() in the harness makes the cases).
/// If no path reaches the end of the theorem, it is refuted, because its assumptions contradict each other. Calls
/// `noted` whenever the statement or the requirements in `result` have changed.
void decide(const Program& program, const Limits& limits, TheoremResult& result, const std::function<void()>& noted);

}  // namespace canproof::host::prove
