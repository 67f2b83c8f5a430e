// SPDX-License-Identifier: Apache-2.0
#include "host/prove/intrinsics.hpp"

#include <llvm/IR/Intrinsics.h>

#include "host/prove/access.hpp"
#include "host/prove/arithmetic.hpp"
#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::uint64_t most_compared = 4096;

/// Returns the name of the sanitizer check to which a trap belongs. The numbers of the checks are clang's own
/// (CodeGenFunction.h).
std::string broken_rule(const Value& arguments) {
    static const std::map<std::uint64_t, std::string> names = {
        {0, "a sum without overflow"},
        {1, "a call of __builtin_unreachable is never reached"},
        {3, "a quotient without overflow and without division by 0"},
        {8, "the end of a function with a result is never reached"},
        {12, "a product without overflow"},
        {13, "a negation without overflow"},
        {18, "an index lies in its array"},
        {20, "a shift by less than the width"},
        {21, "a difference without overflow"}};
    if (!arguments.empty()) {
        const auto rule = number(arguments[0]);
        for (const auto& [code, name] : names) {
            if (rule == code) {
                return name;
            }
        }
    }
    return "a check of the sanitizer holds";
}

CallEffect overflow_checked(Proof& proof, llvm::Intrinsic::ID id, const Value& arguments, Value& result) {
    struct Kind {
        Operation operation;
        bool is_signed;
    };
    static const std::map<llvm::Intrinsic::ID, Kind> kinds = {
        {llvm::Intrinsic::uadd_with_overflow, {Operation::add, false}},
        {llvm::Intrinsic::sadd_with_overflow, {Operation::add, true}},
        {llvm::Intrinsic::usub_with_overflow, {Operation::subtract, false}},
        {llvm::Intrinsic::ssub_with_overflow, {Operation::subtract, true}},
        {llvm::Intrinsic::umul_with_overflow, {Operation::multiply, false}},
        {llvm::Intrinsic::smul_with_overflow, {Operation::multiply, true}}};
    const auto kind = kinds.find(id);
    if (kind == kinds.end()) {
        return CallEffect::none;
    }
    const Checked done = checked(kind->second.operation, arguments[0], arguments[1], kind->second.is_signed);
    static_cast<void>(proof);
    result = {done.value, (!done.exact).simplify()};
    return CallEffect::goes_on;
}

/// Returns the result of memcmp: below zero, zero or above zero, depending on the first byte in which the two ranges
/// differ.
Term memory_compared(Proof& proof, const State& state, const Value& arguments, const std::string& where) {
    const auto count = number(arguments[2]);
    if (!count || *count > most_compared) {
        throw Unknown{where + ": canproof prove does not support comparing memory whose size is not a small constant"};
    }
    constexpr unsigned int_width = 32;
    Term order = constant(proof.context, 0, int_width);
    for (std::uint64_t i = *count; i > 0; --i) {
        const Term at = constant(proof.context, i - 1, address_width);
        const Term a = load(proof, state, moved(proof, state, arguments[0], at, true, where), 1, {1, where});
        const Term b = load(proof, state, moved(proof, state, arguments[1], at, true, where), 1, {1, where});
        order = choose((a == b).simplify(), order, (resized(a, int_width) - resized(b, int_width)).simplify());
    }
    return order;
}

CallEffect library_function(Proof& proof, State& state, const llvm::CallBase& call, const Value& arguments,
                            Value& result) {
    const llvm::Function* callee = call.getCalledFunction();
    if (callee == nullptr) {
        return CallEffect::none;
    }
    const std::string where = where_is(call);
    if (callee->getName() == "memcmp" || callee->getName() == "bcmp") {
        result = {memory_compared(proof, state, arguments, where)};
        return CallEffect::goes_on;
    }
    if (callee->getName() == "memcpy" || callee->getName() == "memmove") {
        copy(proof, state, arguments[0], arguments[1], arguments[2], where);
        result = {arguments[0]};
        return CallEffect::goes_on;
    }
    if (callee->isDeclaration() && callee->doesNotReturn()) {
        proof.obligations.add(state.path, proof.context.bool_val(false),
                              "`" + callee->getName().str() + "` is never called", where);
        return CallEffect::path_ends;
    }
    return CallEffect::none;
}

}  // namespace

CallEffect call_intrinsic(Proof& proof, State& state, const llvm::CallBase& call, const Value& arguments,
                          Value& result) {
    const llvm::Intrinsic::ID id = call.getIntrinsicID();
    const std::string where = where_is(call);
    switch (id) {
        case llvm::Intrinsic::not_intrinsic:
            return library_function(proof, state, call, arguments, result);
        case llvm::Intrinsic::lifetime_start:
        case llvm::Intrinsic::lifetime_end:
        case llvm::Intrinsic::experimental_noalias_scope_decl:
        case llvm::Intrinsic::dbg_declare:
        case llvm::Intrinsic::dbg_value:
            return CallEffect::goes_on;
        case llvm::Intrinsic::trap:
        case llvm::Intrinsic::ubsantrap:
            proof.obligations.add(state.path, proof.context.bool_val(false), broken_rule(arguments), where);
            return CallEffect::path_ends;
        case llvm::Intrinsic::assume:
            proof.obligations.add(state.path, as_truth(arguments[0]), "an assumption of the compiler holds", where);
            return CallEffect::goes_on;
        case llvm::Intrinsic::expect:
        case llvm::Intrinsic::launder_invariant_group:
            result = {arguments[0]};
            return CallEffect::goes_on;
        case llvm::Intrinsic::is_constant:
            result = {proof.context.bool_val(false)};
            return CallEffect::goes_on;
        case llvm::Intrinsic::memcpy:
        case llvm::Intrinsic::memmove:
            copy(proof, state, arguments[0], arguments[1], resized(arguments[2], address_width), where);
            return CallEffect::goes_on;
        case llvm::Intrinsic::memset:
            fill(proof, state, arguments[0], arguments[1], resized(arguments[2], address_width), where);
            return CallEffect::goes_on;
        default:
            break;
    }
    if (overflow_checked(proof, id, arguments, result) == CallEffect::goes_on) {
        return CallEffect::goes_on;
    }
    if (!arguments.empty()) {
        if (const auto number = proof.floats.computed(id, *call.getArgOperand(0)->getType(), arguments)) {
            result = {*number};
            return CallEffect::goes_on;
        }
    }
    const auto done = arguments.empty() ? std::nullopt : computed(id, arguments);
    if (!done) {
        return CallEffect::none;
    }
    proof.obligations.add(state.path, done->defined, "the result of an operation is defined", where);
    result = {done->value};
    return CallEffect::goes_on;
}

}  // namespace canproof::host::prove
