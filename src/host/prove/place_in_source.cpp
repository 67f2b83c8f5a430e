// SPDX-License-Identifier: Apache-2.0
#include "host/prove/place_in_source.hpp"

#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/Instruction.h>

namespace canproof::host::prove {

std::string readable_name(const llvm::Function& function) {
    return llvm::demangle(function.getName().str());
}

std::string where_is(const llvm::Instruction& instruction) {
    const std::string name = readable_name(*instruction.getFunction());
    const llvm::DILocation* place = instruction.getDebugLoc().get();
    if (place == nullptr) {
        return name;
    }
    return name + ", " + place->getFilename().str() + ":" + std::to_string(place->getLine());
}

std::string file_of(const llvm::Function& function) {
    const llvm::DISubprogram* entry = function.getSubprogram();
    return entry == nullptr ? "" : entry->getFilename().str();
}

unsigned line_of(const llvm::Function& function) {
    const llvm::DISubprogram* entry = function.getSubprogram();
    return entry == nullptr ? 0 : entry->getLine();
}

}  // namespace canproof::host::prove
