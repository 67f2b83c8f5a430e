// SPDX-License-Identifier: Apache-2.0
// The arithmetic of LLVM's instructions on terms.
#pragma once

#include <llvm/IR/Instructions.h>
#include <llvm/IR/Intrinsics.h>

#include <optional>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// The result of an instruction, and the condition under which the result is defined; otherwise the behaviour is
/// undefined.
struct Computed {
    Term value;
    Term defined;
};

/// Each of these three functions returns nothing for an operation that the prover does not model, such as one on
/// floating-point numbers.
std::optional<Computed> computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b);
std::optional<Term> compared(llvm::CmpInst::Predicate predicate, const Term& a, const Term& b);
std::optional<Term> converted(const llvm::CastInst& cast, const Term& from, unsigned width);

/// The result of `a + b`, `a - b` or `a * b` cut to the width of `a`, and whether it is exact, that is, no bits were
/// cut off.
struct Checked {
    Term value;
    Term exact;
};
enum class Operation { add, subtract, multiply };
Checked checked(Operation operation, const Term& a, const Term& b, bool is_signed);

/// The result of an LLVM intrinsic that only computes: minimum, maximum, absolute value, rotation, number of bits that
/// are set and the like. Empty for one that is not modelled.
std::optional<Computed> computed(llvm::Intrinsic::ID function, const std::vector<Term>& arguments);

}  // namespace canproof::host::prove
