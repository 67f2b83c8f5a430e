// SPDX-License-Identifier: Apache-2.0
// Computes the results of LLVM's arithmetic instructions as terms.
#pragma once

#include <llvm/IR/Instructions.h>
#include <llvm/IR/Intrinsics.h>

#include <optional>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// The result of an instruction, and the condition under which it is defined. When the condition is false, the
/// behaviour of the program is undefined.
struct Computed {
    Term value;
    Term defined;
};

/// These three functions return the result of an instruction. They return nothing for an operation that the prover does
/// not model, such as one on floating-point numbers.
std::optional<Computed> computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b);
std::optional<Term> compared(llvm::CmpInst::Predicate predicate, const Term& a, const Term& b);
std::optional<Term> converted(const llvm::CastInst& cast, const Term& from, unsigned width);

/// The result of `a + b`, `a - b` or `a * b`, reduced to the width of `a`. `exact` is true if the reduction has removed
/// no significant bits.
struct Checked {
    Term value;
    Term exact;
};
enum class Operation { add, subtract, multiply };
Checked checked(Operation operation, const Term& a, const Term& b, bool is_signed);

/// Returns the result of an LLVM intrinsic that only computes: minimum, maximum, absolute value, rotation, number of
/// set bits and similar functions. Returns nothing for an intrinsic that is not modelled.
std::optional<Computed> computed(llvm::Intrinsic::ID function, const std::vector<Term>& arguments);

}  // namespace canproof::host::prove
