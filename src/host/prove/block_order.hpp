// SPDX-License-Identifier: Apache-2.0
// The order in which the prover executes the basic blocks of a function. It lets paths merge early.
#pragma once

#include <map>

namespace llvm {
class BasicBlock;
class Function;
}  // namespace llvm

namespace canproof::host::prove {

/// Returns the position of each block. A block comes after all blocks that lead to it, except those that jump back to
/// the start of a loop. The blocks after a loop come after all blocks of the loop. The order does not change the
/// verdict about a theorem. With this order, all passes of a loop are merged before the blocks after the loop are
/// executed, so that each of these blocks is executed only once.
std::map<const llvm::BasicBlock*, unsigned> block_order(const llvm::Function& function);

}  // namespace canproof::host::prove
