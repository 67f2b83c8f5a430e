// SPDX-License-Identifier: Apache-2.0
// Executes a function with terms instead of numbers on all its paths at once. Paths split at branches, and they are
// merged where they reach the same block.
#pragma once

#include <llvm/IR/Dominators.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <map>
#include <unordered_map>

#include "host/prove/globals.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

using Values = std::unordered_map<const llvm::Value*, Value>;

/// All paths that have reached a block so far, merged into one.
struct Arrival {
    State state;
    Values values;
};

/// The value and the state of a function when it returns.
struct Return {
    State state;
    Value value;
};

struct AnyPass;

class Machine {
  public:
    Machine(Proof& proof, const llvm::Module& module)
        : proof_{proof}, layout_{module.getDataLayout()}, globals_{proof, layout_} {}

    /// Executes a call. Returns nothing when no path returns from the call. Throws Unknown for anything that the prover
    /// does not model.
    std::optional<Return> call(const llvm::Function& function, const std::vector<Value>& arguments, State state);

  private:
    struct Frame;

    void run_block(Frame& frame, const llvm::BasicBlock& block, Arrival arrival);
    /// Executes one instruction. Returns false when the path ends there.
    bool run(Frame& frame, const llvm::Instruction& instruction, Arrival& arrival);
    void leave(Frame& frame, const llvm::Instruction& terminator, Arrival arrival);
    void branch(Frame& frame, const llvm::BranchInst& branch, Arrival arrival);
    void choose_case(Frame& frame, const llvm::SwitchInst& choice, Arrival arrival);
    void go(Frame& frame, const llvm::BasicBlock& from, const llvm::BasicBlock& to, Arrival arrival);
    void finish(Frame& frame, const llvm::ReturnInst& end, const Arrival& arrival);
    void join(Arrival& first, const Arrival& second, const llvm::BasicBlock& at);
    /// Returns whether a block can use a value: every path to the block passes the instruction that defines the value.
    bool is_usable(const llvm::Value& value, const llvm::BasicBlock& at);
    Value joined(const Term& condition, const Value& first, const Value& second, const llvm::Value* of);
    bool possible(const State& state, const Term& condition, unsigned milliseconds);

    /// Returns the loops of a function for which the harness states an invariant.
    std::vector<AnyPass> stated_loops(const llvm::Function& function) const;
    /// Claims the invariant before the first pass of a loop. Then leaves open what a pass changes, and assumes the
    /// invariant.
    void begin_any_pass(AnyPass& pass, Arrival& arrival);
    /// Claims the invariant after a pass, and that the pass changed nothing but what the harness names.
    void end_any_pass(const AnyPass& pass, const llvm::BasicBlock& last, const Arrival& arrival);
    void open_phis(const AnyPass& pass, Arrival& arrival);
    void open_memory(AnyPass& pass, Arrival& arrival);
    void check_changes(const AnyPass& pass, const Arrival& arrival, const std::string& where);
    /// Executes the function that states an invariant, with the values of the variables at the header of the loop.
    Term invariant(const AnyPass& pass, const Term& passes, const Values& values, State& state);
    /// Returns the function at an address; nullptr when there is none.
    const llvm::Function* function_at(const Term& address) const;
    /// Returns the function of the harness that stands for a function, or the function itself.
    const llvm::Function& executed(const llvm::Function& function);

    bool run_call(Frame& frame, const llvm::CallBase& call, Arrival& arrival);
    bool call_function(const llvm::CallBase& call, const llvm::Function& callee, const std::vector<Value>& arguments,
                       Arrival& arrival);
    bool call_address(const llvm::CallBase& call, const std::vector<Value>& arguments, Arrival& arrival);
    std::vector<Value> arguments_of(Frame& frame, const llvm::CallBase& call, Arrival& arrival);

    Value evaluate(Frame& frame, const llvm::Instruction& instruction, Arrival& arrival);
    /// Returns the result of an instruction on floating-point numbers; nothing for any other instruction.
    std::optional<Term> evaluate_float(const llvm::Instruction& instruction, const Arrival& arrival);
    Value load_value(const llvm::LoadInst& load, const Arrival& arrival);
    void check_range(const llvm::LoadInst& load, const Term& value, const Arrival& arrival);
    void store_value(const llvm::StoreInst& store, Arrival& arrival);
    Value address_of(const llvm::GetElementPtrInst& place, const Arrival& arrival);
    Value new_object(Frame& frame, const llvm::AllocaInst& made, Arrival& arrival);
    Term compared(const llvm::ICmpInst& comparison, const Arrival& arrival);
    Value operand(const llvm::Value* value, const Arrival& arrival);
    Term scalar(const llvm::Value* value, const Arrival& arrival) { return operand(value, arrival).front(); }
    unsigned bits_of(llvm::Type* type) const;

    Proof& proof_;
    const llvm::DataLayout& layout_;
    Globals globals_;
    unsigned depth_{0};
    std::map<const llvm::Function*, std::map<const llvm::BasicBlock*, unsigned>> orders_;
    std::map<const llvm::Function*, llvm::DominatorTree> dominators_;
};

}  // namespace canproof::host::prove
