// SPDX-License-Identifier: Apache-2.0
// The order in which the basic blocks of a function are executed, so that paths can be merged again soon.
#pragma once

#include <map>

namespace llvm {
class BasicBlock;
class Function;
}  // namespace llvm

namespace canproof::host::prove {

/// Computes the position of each block. A block comes after all blocks that lead to it, except those that jump back to
/// the start of a loop. The blocks behind a loop come after the whole loop. Every order gives the same verdict; in this
/// one all passes of a loop are merged before the blocks behind the loop are executed, once.
std::map<const llvm::BasicBlock*, unsigned> block_order(const llvm::Function& function);

}  // namespace canproof::host::prove
