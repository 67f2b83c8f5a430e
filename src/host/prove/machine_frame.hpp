// SPDX-License-Identifier: Apache-2.0
// The state of one call during its execution.
#pragma once

#include "host/prove/loop_rule.hpp"
#include "host/prove/machine.hpp"

namespace canproof::host::prove {

/// A loop that is executed once, for any pass.
struct AnyPass {
    const LoopRule* rule{};
    Loop loop{};
    std::optional<Term> passes{};     ///< number of passes before this one
    Memory before{};                  ///< the memory before this pass
    std::set<ObjectId> own{};         ///< variable objects that only the loop uses
    std::optional<ObjectId> named{};  ///< the object that contains the bytes which the harness names
    std::set<std::uint64_t> open{};   ///< offsets of the bytes of the named object that may have any values
};

struct Machine::Frame {
    const llvm::Function& function;
    const std::map<const llvm::BasicBlock*, unsigned>& order;
    std::map<unsigned, Arrival> waiting{};  ///< merged paths that wait for a block, by the block's position
    std::map<unsigned, const llvm::BasicBlock*> blocks{};  ///< block by its position
    std::map<const llvm::BasicBlock*, unsigned> visits{};
    std::vector<ObjectId> locals{};
    std::vector<AnyPass> any_passes{};  ///< the loops of the function for which the harness states an invariant
    std::optional<Return> result{};
};

}  // namespace canproof::host::prove
