// SPDX-License-Identifier: Apache-2.0
#include "host/prove/theorem.hpp"

#include <llvm/IR/Function.h>

#include <algorithm>

#include "host/prove/machine.hpp"
#include "host/prove/source_statement.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::uint64_t most_memory_bytes = 4096;  ///< most bytes of one memory that a counterexample holds

int byte_in(const z3::model& model, const Term& byte) {
    return static_cast<int>(number(model.eval(byte, true)).value_or(0));
}

InputBytes memory_in(const z3::model& model, const Input& input) {
    const std::uint64_t size = std::min(number(model.eval(*input.size, true)).value_or(0), most_memory_bytes);
    InputBytes bytes(size, 0);
    for (const AskedByte& one : input.memory->asked()) {
        const std::uint64_t at = number(model.eval(one.offset, true)).value_or(size);
        if (at < size) {
            bytes[at] = byte_in(model, one.value);
        }
    }
    return bytes;
}

std::vector<InputBytes> inputs_in(const z3::model& model, const std::vector<Input>& inputs) {
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

/// Returns the preference that each memory of any size is small, so that the counterexample can be written to a file
/// and run.
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

/// Refutes a theorem whose end no values reach: its assumptions contradict each other, so that it would prove nothing.
void refuse_vacuous(Proof& proof, const std::optional<Return>& end, TheoremResult& result) {
    const Answer reached = end ? proof.solver.satisfiable(end->state.path, 1000 * proof.limits.seconds) : Answer::no;
    if (reached == Answer::no) {
        result.verdict = Verdict::refuted;
        result.reason = "no path comes to its end: its assumptions contradict each other";
    } else if (reached == Answer::unknown) {
        result.verdict = Verdict::unknown;
        result.reason = "whether its assumptions can hold at all is not decided in time";
    }
}

}  // namespace

void decide(const Program& program, const Limits& limits, TheoremResult& result, const std::function<void()>& noted) {
    Proof proof{limits};
    proof.noted = [&] {
        result.statement = proof.statement;
        result.requirements = proof.requirements;
        noted();
    };
    try {
        Machine machine{proof, program.module()};
        const auto end = machine.call(program.theorem(result.name), {}, State{});
        const Obligations::Outcome outcome = proof.obligations.settle(1000 * limits.seconds, small_memory(proof));
        result.verdict = outcome.verdict;
        result.reason = outcome.reason;
        if (outcome.counterexample) {
            result.inputs = inputs_in(*outcome.counterexample, proof.inputs);
        }
        if (outcome.verdict == Verdict::proven) {
            refuse_vacuous(proof, end, result);
        }
        result.paths = end ? end->state.paths : 0.0;
    } catch (const Unknown& why) {
        result.verdict = Verdict::unknown;
        result.reason = why.what();
    } catch (const z3::exception& error) {
        result.verdict = Verdict::unknown;
        result.reason = std::string{"z3: "} + error.msg();
    }
    result.functions.assign(proof.functions.begin(), proof.functions.end());
    for (const std::string& place : proof.assumptions) {
        result.assumptions.push_back(place + ": " + statement_at(place));
    }
    result.obligations = proof.obligations.size();
    result.questions = proof.solver.questions();
}

}  // namespace canproof::host::prove
