// SPDX-License-Identifier: Apache-2.0
#include "host/prove/theorem.hpp"

#include <llvm/IR/Function.h>

#include <algorithm>
#include <set>

#include "host/prove/machine.hpp"
#include "host/prove/source_statement.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::uint64_t most_memory_bytes = 4096;  ///< greatest number of bytes of one memory in a counterexample

int byte_in(Assignment& model, const Term& byte) {
    return static_cast<int>(model.of(byte).value_or(0));
}

InputBytes memory_in(Assignment& model, const Input& input) {
    const std::uint64_t size =
        static_cast<std::uint64_t>(std::min(model.of(*input.size).value_or(0), Bits{most_memory_bytes}));
    InputBytes bytes(size, 0);
    for (const AskedByte& one : input.memory->asked()) {
        const Bits at = model.of(one.offset).value_or(size);
        if (at < size) {
            bytes[static_cast<std::size_t>(at)] = byte_in(model, one.value);
        }
    }
    return bytes;
}

std::vector<InputBytes> inputs_in(Assignment& model, const std::vector<Input>& inputs) {
    std::vector<InputBytes> all;
    for (const Input& input : inputs) {
        InputBytes bytes;
        if (input.memory) {
            bytes = memory_in(model, input);
        }
        for (const auto& byte : input.bytes) {
            bytes.push_back(byte ? byte_in(model, *byte) : -1);
        }
        all.push_back(std::move(bytes));
    }
    return all;
}

/// Returns the conditions that each memory made by any_memory() is small. The counterexample can then be written to a
/// file and run.
std::vector<Term> small_memory(Proof& proof) {
    constexpr std::uint64_t small = 64;
    std::vector<Term> all;
    for (const Input& input : proof.inputs) {
        if (input.size) {
            all.push_back(z3::ule(*input.size, constant(proof.context, small, address_width)));
        }
    }
    return all;
}

/// Returns whether some values of the inputs reach the end of a case.
Answer reaches_end(Proof& proof, const std::optional<Return>& end) {
    return end ? proof.solver.satisfiable(end->state.path, 1000 * proof.limits.seconds) : Answer::no;
}

/// Adds the functions, the assumptions and the numbers of obligations and questions of a case to those of its theorem.
void add_figures(const Proof& proof, TheoremResult& result) {
    std::set<std::string> functions{result.functions.begin(), result.functions.end()};
    functions.insert(proof.functions.begin(), proof.functions.end());
    result.functions.assign(functions.begin(), functions.end());
    std::set<std::string> assumptions{result.assumptions.begin(), result.assumptions.end()};
    for (const std::string& place : proof.assumptions) {
        assumptions.insert(place + ": " + statement_at(place));
    }
    result.assumptions.assign(assumptions.begin(), assumptions.end());
    std::set<std::string> used{result.used_theorems.begin(), result.used_theorems.end()};
    used.insert(proof.used_theorems.begin(), proof.used_theorems.end());
    result.used_theorems.assign(used.begin(), used.end());
    result.obligations += proof.obligations.size();
    result.questions += proof.solver.questions();
}

/// Decides one case. If it is proven, returns whether some values reach the end of the theorem; otherwise returns `no`.
Answer decide_case(const Program& program, Proof& proof, TheoremResult& result) {
    Answer reached = Answer::no;
    try {
        Machine machine{proof, program.module()};
        const auto end = machine.call(program.theorem(result.name), {}, State{});
        Obligations::Outcome outcome = proof.obligations.settle(1000 * proof.limits.seconds, small_memory(proof));
        result.verdict = outcome.verdict;
        result.reason = outcome.reason;
        if (outcome.verdict == Verdict::refuted && proof.is_modular) {
            // the values satisfy the invariants and contracts, but perhaps no run of the program leads to them
            result.verdict = Verdict::unknown;
            result.reason += ": not shown with the stated invariants and contracts";
        } else if (outcome.counterexample) {
            result.inputs = inputs_in(*outcome.counterexample, proof.inputs);
        }
        if (outcome.verdict == Verdict::proven) {
            reached = reaches_end(proof, end);
        }
        result.paths += end ? end->state.paths : 0.0;
    } catch (const Unknown& why) {
        result.verdict = Verdict::unknown;
        result.reason = why.what();
    } catch (const z3::exception& error) {
        result.verdict = Verdict::unknown;
        result.reason = std::string{"z3: "} + error.msg();
    }
    if (const std::string text = proof.at.text(); !text.empty() && result.verdict != Verdict::proven) {
        result.reason += " (case " + text + ")";
    }
    add_figures(proof, result);
    return reached;
}

}  // namespace

void decide(const Program& program, const Limits& limits, TheoremResult& result, const std::function<void()>& noted) {
    Case one;
    Answer reached = Answer::no;
    do {
        Proof proof{limits, one};
        const std::string name = one.text();
        // the name of the case remains in the result if the process ends at its time limit
        result.reason = name.empty() ? "" : " (case " + name + ")";
        proof.noted = [&] {
            result.statement = proof.statement;
            result.requirements = proof.requirements;
            noted();
        };
        const Answer here = decide_case(program, proof, result);
        reached = here == Answer::no || reached == Answer::yes ? reached : here;
    } while (result.verdict == Verdict::proven && one.next());
    if (result.verdict == Verdict::proven && reached == Answer::no) {
        result.verdict = Verdict::refuted;
        result.reason = "no values reach the end of the theorem: its assumptions contradict each other";
    } else if (result.verdict == Verdict::proven && reached == Answer::unknown) {
        result.verdict = Verdict::unknown;
        result.reason = "it is not decided in time whether the assumptions can hold at all";
    }
}

}  // namespace canproof::host::prove
