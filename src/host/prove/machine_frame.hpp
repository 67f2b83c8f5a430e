// One call under way.
#pragma once

#include "host/prove/machine.hpp"

namespace canproof::host::prove {

struct Machine::Frame {
    const llvm::Function& function;
    const std::map<const llvm::BasicBlock*, unsigned>& order;
    std::map<unsigned, Arrival> waiting{};                 ///< by position of the block
    std::map<unsigned, const llvm::BasicBlock*> blocks{};  ///< by position
    std::map<const llvm::BasicBlock*, unsigned> visits{};
    std::vector<ObjectId> locals{};
    std::optional<Return> result{};
};

}  // namespace canproof::host::prove
