// Which scalars a type consists of.
#pragma once

#include <llvm/IR/DataLayout.h>
#include <llvm/IR/DerivedTypes.h>

#include <cstdint>
#include <vector>

namespace canproof::host::prove {

/// One scalar of a type: so many bytes behind its start.
struct Scalar {
    std::uint64_t offset{0};
    llvm::Type* type{nullptr};
};

/// The scalars of a type in order; a scalar alone has one. Padding has none.
std::vector<Scalar> scalars_of(llvm::Type* type, const llvm::DataLayout& layout);
/// Which of the scalars of `type` the indices of an aggregate instruction mean: the first, and how many.
struct ScalarRange {
    std::size_t first{0};
    std::size_t count{0};
};
ScalarRange scalars_at(llvm::Type* type, const std::vector<unsigned>& indices, const llvm::DataLayout& layout);

}  // namespace canproof::host::prove
