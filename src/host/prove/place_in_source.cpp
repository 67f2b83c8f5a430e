// SPDX-License-Identifier: Apache-2.0
#include "host/prove/place_in_source.hpp"

#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/Instruction.h>

#include <algorithm>

namespace canproof::host::prove {

namespace {

/// Returns a readable name up to the parenthesis that begins the parameters. Parameters may contain parentheses, such
/// as those of an unnamed namespace.
std::string without_parameters(const std::string& name) {
    int open = 0;
    for (std::size_t at = name.rfind(')'); at != std::string::npos && at > 0; --at) {
        open += name[at] == ')' ? 1 : (name[at] == '(' ? -1 : 0);
        if (open == 0) {
            return name.substr(0, at);
        }
    }
    return name;
}

}  // namespace

std::string readable_name(const llvm::Function& function) {
    return llvm::demangle(function.getName().str());
}

bool is_named(const llvm::Function& function, const std::string& name) {
    const std::string text = without_parameters(readable_name(function));
    const std::size_t at = text.size() - std::min(text.size(), name.size());
    return text.substr(at) == name && (at == 0 || text[at - 1] == ':');
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
