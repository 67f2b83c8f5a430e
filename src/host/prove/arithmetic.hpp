// The arithmetic of LLVM's instructions on terms.
#pragma once

#include <llvm/IR/Instructions.h>
#include <llvm/IR/Intrinsics.h>

#include <optional>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// A result, and what must be true for the instruction to have one.
struct Computed {
    Term value;
    Term defined;
};

/// Empty for an operation that is not modelled, such as one on floating-point numbers.
std::optional<Computed> computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b);
std::optional<Term> compared(llvm::CmpInst::Predicate predicate, const Term& a, const Term& b);
std::optional<Term> converted(const llvm::CastInst& cast, const Term& from, unsigned width);

/// `a + b`, `a - b` or `a * b`, and whether that is the exact result.
struct Checked {
    Term value;
    Term exact;
};
enum class Operation { add, subtract, multiply };
Checked checked(Operation operation, const Term& a, const Term& b, bool is_signed);

/// Intrinsics that compute: smallest, greatest, absolute value, rotations, counts of bits …
std::optional<Computed> computed(llvm::Intrinsic::ID function, const std::vector<Term>& arguments);

}  // namespace canproof::host::prove
