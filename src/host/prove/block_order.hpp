// In which order the blocks of a function are executed, so that paths meet where they can.
#pragma once

#include <map>

namespace llvm {
class BasicBlock;
class Function;
}  // namespace llvm

namespace canproof::host::prove {

/// The position of each block: behind all that lead to it, and what follows a loop behind the whole loop. Any order is
/// right; this one lets all passes of a loop meet before what follows is executed once.
std::map<const llvm::BasicBlock*, unsigned> block_order(const llvm::Function& function);

}  // namespace canproof::host::prove
