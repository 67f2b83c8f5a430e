// SPDX-License-Identifier: Apache-2.0
#include "host/prove/block_order.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/CFG.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/Function.h>

#include <set>
#include <vector>

namespace canproof::host::prove {

namespace {

/// Returns the successors of a block, those in fewer loops first. block_order() gives the first of them the last
/// position. So the blocks after a loop come after the blocks of the loop.
std::vector<const llvm::BasicBlock*> successors_of(const llvm::BasicBlock& block, const llvm::LoopInfo& loops) {
    std::multimap<unsigned, const llvm::BasicBlock*> by_depth;
    for (const llvm::BasicBlock* one : llvm::successors(&block)) {
        by_depth.emplace(loops.getLoopDepth(one), one);
    }
    std::vector<const llvm::BasicBlock*> all;
    for (const auto& [depth, one] : by_depth) {
        all.push_back(one);
    }
    return all;
}

}  // namespace

std::map<const llvm::BasicBlock*, unsigned> block_order(const llvm::Function& function) {
    llvm::DominatorTree dominators{const_cast<llvm::Function&>(function)};
    const llvm::LoopInfo loops{dominators};
    struct Open {
        const llvm::BasicBlock* block;
        std::vector<const llvm::BasicBlock*> successors;
        std::size_t next{0};
    };
    std::vector<const llvm::BasicBlock*> finished;
    std::set<const llvm::BasicBlock*> seen{&function.getEntryBlock()};
    std::vector<Open> open{{&function.getEntryBlock(), successors_of(function.getEntryBlock(), loops)}};
    while (!open.empty()) {
        Open& top = open.back();
        if (top.next == top.successors.size()) {
            finished.push_back(top.block);
            open.pop_back();
            continue;
        }
        const llvm::BasicBlock* next = top.successors[top.next++];
        if (seen.insert(next).second) {
            open.push_back({next, successors_of(*next, loops)});
        }
    }
    std::map<const llvm::BasicBlock*, unsigned> order;
    unsigned position = 0;
    for (auto block = finished.rbegin(); block != finished.rend(); ++block) {
        order[*block] = position++;
    }
    return order;
}

}  // namespace canproof::host::prove
