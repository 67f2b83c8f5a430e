// SPDX-License-Identifier: Apache-2.0
// The state of one call during its execution.
#pragma once

#include "host/prove/machine.hpp"

namespace canproof::host::prove {

struct Machine::Frame {
    const llvm::Function& function;
    const std::map<const llvm::BasicBlock*, unsigned>& order;
    std::map<unsigned, Arrival> waiting{};  ///< merged paths that wait for a block, by the block's position
    std::map<unsigned, const llvm::BasicBlock*> blocks{};  ///< block by its position
    std::map<const llvm::BasicBlock*, unsigned> visits{};
    std::vector<ObjectId> locals{};
    std::optional<Return> result{};
};

}  // namespace canproof::host::prove
