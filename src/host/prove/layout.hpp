// SPDX-License-Identifier: Apache-2.0
// Divides a type into its scalars: the numbers, truth values and addresses that it consists of.
#pragma once

#include <llvm/IR/DataLayout.h>
#include <llvm/IR/DerivedTypes.h>

#include <cstdint>
#include <vector>

namespace canproof::host::prove {

/// One scalar of a type; `offset` is its distance in bytes from the start of the type.
struct Scalar {
    std::uint64_t offset{0};
    llvm::Type* type{nullptr};
};

/// Returns the scalars of a type in order. A scalar type has one: itself. Padding bytes belong to no scalar.
std::vector<Scalar> scalars_of(llvm::Type* type, const llvm::DataLayout& layout);
/// The part of a structure or array that the indices of an LLVM instruction select: the number of its first scalar in
/// `type`, and the number of its scalars.
struct ScalarRange {
    std::size_t first{0};
    std::size_t count{0};
};
ScalarRange scalars_at(llvm::Type* type, const std::vector<unsigned>& indices, const llvm::DataLayout& layout);

}  // namespace canproof::host::prove
