// SPDX-License-Identifier: Apache-2.0
#include "host/prove/layout.hpp"

namespace canproof::host::prove {

namespace {

void append(std::vector<Scalar>& all, llvm::Type* type, std::uint64_t at, const llvm::DataLayout& layout) {
    if (auto* record = llvm::dyn_cast<llvm::StructType>(type)) {
        const llvm::StructLayout* places = layout.getStructLayout(record);
        for (unsigned i = 0; i < record->getNumElements(); ++i) {
            append(all, record->getElementType(i), at + places->getElementOffset(i).getFixedValue(), layout);
        }
    } else if (auto* array = llvm::dyn_cast<llvm::ArrayType>(type)) {
        const std::uint64_t step = layout.getTypeAllocSize(array->getElementType()).getFixedValue();
        for (std::uint64_t i = 0; i < array->getNumElements(); ++i) {
            append(all, array->getElementType(), at + i * step, layout);
        }
    } else {
        all.push_back({at, type});
    }
}

llvm::Type* element(llvm::Type* type, unsigned at) {
    auto* record = llvm::dyn_cast<llvm::StructType>(type);
    return record != nullptr ? record->getElementType(at) : llvm::cast<llvm::ArrayType>(type)->getElementType();
}

}  // namespace

std::vector<Scalar> scalars_of(llvm::Type* type, const llvm::DataLayout& layout) {
    std::vector<Scalar> all;
    append(all, type, 0, layout);
    return all;
}

ScalarRange scalars_at(llvm::Type* type, const std::vector<unsigned>& indices, const llvm::DataLayout& layout) {
    std::size_t first = 0;
    llvm::Type* now = type;
    for (const unsigned index : indices) {
        for (unsigned before = 0; before < index; ++before) {
            first += scalars_of(element(now, before), layout).size();
        }
        now = element(now, index);
    }
    return {first, scalars_of(now, layout).size()};
}

}  // namespace canproof::host::prove
