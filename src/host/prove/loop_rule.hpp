// SPDX-License-Identifier: Apache-2.0
// The rule of loops: a theorem about a loop with any number of passes, by an invariant that the harness states.
#pragma once

#include <llvm/IR/Dominators.h>
#include <llvm/IR/Instructions.h>

#include <set>
#include <string>
#include <vector>

#include "host/prove/proof.hpp"

namespace canproof::host::prove {

/// An outermost loop of a function, which the prover executes once, for any pass.
struct Loop {
    const llvm::BasicBlock* header{};
    std::set<const llvm::BasicBlock*> blocks{};
    /// variable objects of the function that only the loop uses: they may have any content before a pass
    std::set<const llvm::AllocaInst*> own{};

    bool repeats(const llvm::BasicBlock& from, const llvm::BasicBlock& to) const {
        return &to == header && blocks.count(&from) != 0;
    }
};

/// Returns the outermost loop of a function with this number, counted from 0 in the order of the source. Throws Unknown
/// when there is none.
Loop outermost_loop(const llvm::Function& function, std::size_t number);

/// Returns the local variable of this name that changes in the loop; nullptr when there is none.
const llvm::PHINode* variable_of(const Loop& loop, const std::string& name);

/// Returns what a counter of the loop adds in each pass, such as 1; nothing when `phi` is no counter.
std::optional<std::uint64_t> step_of(const llvm::PHINode& phi, const Loop& loop);

}  // namespace canproof::host::prove
