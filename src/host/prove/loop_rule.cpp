// SPDX-License-Identifier: Apache-2.0
#include "host/prove/loop_rule.hpp"

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/IntrinsicInst.h>

#include <algorithm>

#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

bool is_used_in_loop_only(const llvm::AllocaInst& object, const Loop& loop) {
    return std::all_of(object.user_begin(), object.user_end(), [&](const llvm::User* user) {
        const auto* instruction = llvm::dyn_cast<llvm::Instruction>(user);
        return instruction != nullptr && loop.blocks.count(instruction->getParent()) != 0;
    });
}

}  // namespace

Loop outermost_loop(const llvm::Function& function, std::size_t number) {
    llvm::DominatorTree dominators{const_cast<llvm::Function&>(function)};
    const llvm::LoopInfo loops{dominators};
    std::vector<const llvm::Loop*> in_order;
    for (const llvm::BasicBlock& block : function) {
        const llvm::Loop* loop = loops.getLoopFor(&block);
        if (loop != nullptr && loop->getHeader() == &block && loop->getParentLoop() == nullptr) {
            in_order.push_back(loop);
        }
    }
    if (number >= in_order.size()) {
        throw Unknown{readable_name(function) + ": an invariant is stated for loop " + std::to_string(number) + " of " +
                      std::to_string(in_order.size()) + ", counted from 0"};
    }
    const llvm::Loop& chosen = *in_order[number];
    Loop loop{chosen.getHeader(), {chosen.block_begin(), chosen.block_end()}};
    for (const llvm::Instruction& instruction : function.getEntryBlock()) {
        const auto* object = llvm::dyn_cast<llvm::AllocaInst>(&instruction);
        if (object != nullptr && is_used_in_loop_only(*object, loop)) {
            loop.own.insert(object);
        }
    }
    return loop;
}

const llvm::PHINode* variable_of(const Loop& loop, const std::string& name) {
    const llvm::PHINode* numbered = nullptr;
    for (const llvm::PHINode& phi : loop.header->phis()) {
        const llvm::StringRef given = phi.getName().substr(0, phi.getName().rfind('.'));  // `kept` of `kept.0`
        if (given == name) {
            return &phi;
        }
        if (given.rtrim("0123456789") == name) {  // LLVM adds a number to a name that another value already has
            numbered = &phi;
        }
    }
    return numbered;
}

std::optional<std::uint64_t> step_of(const llvm::PHINode& phi, const Loop& loop) {
    std::optional<std::uint64_t> step;
    for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
        if (loop.blocks.count(phi.getIncomingBlock(i)) == 0) {
            continue;
        }
        const auto* sum = llvm::dyn_cast<llvm::BinaryOperator>(phi.getIncomingValue(i));
        const auto* more = sum == nullptr ? nullptr : llvm::dyn_cast<llvm::ConstantInt>(sum->getOperand(1));
        if (more == nullptr || sum->getOpcode() != llvm::Instruction::Add || sum->getOperand(0) != &phi ||
            more->getBitWidth() > address_width || (step && *step != more->getZExtValue())) {
            return std::nullopt;
        }
        step = more->getZExtValue();
    }
    return step;
}

}  // namespace canproof::host::prove
