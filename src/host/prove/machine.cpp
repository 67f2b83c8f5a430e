// SPDX-License-Identifier: Apache-2.0
// Executes calls, blocks and branches, and merges paths.
#include "host/prove/machine.hpp"

#include "host/prove/block_order.hpp"
#include "host/prove/machine_frame.hpp"
#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

/// Counts one more nested call while this object exists.
class Deeper {
  public:
    explicit Deeper(unsigned& depth) : depth_{depth} { ++depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --depth_; }

  private:
    unsigned& depth_;
};

}  // namespace

std::optional<Return> Machine::call(const llvm::Function& function, const std::vector<Value>& arguments, State state) {
    const Deeper deeper{depth_};
    if (depth_ > proof_.limits.depth) {
        throw Unknown{readable_name(function) + ": calls are nested more than " + std::to_string(proof_.limits.depth) +
                      " deep, which is the limit"};
    }
    auto order = orders_.find(&function);
    if (order == orders_.end()) {
        order = orders_.emplace(&function, block_order(function)).first;
    }
    const std::string file = file_of(function);
    for (const char* const folder : {"src/firmware/", "src/devices/", "src/target/"}) {
        if (file.find(folder) != std::string::npos) {
            proof_.functions.insert(readable_name(function));
        }
    }
    Frame frame{function, order->second};
    frame.any_passes = stated_loops(function);
    for (const auto& [block, position] : order->second) {
        frame.blocks[position] = block;
    }
    Arrival start{std::move(state), {}};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        start.values[function.getArg(static_cast<unsigned>(i))] = arguments[i];
    }
    frame.waiting.emplace(0, std::move(start));
    while (!frame.waiting.empty()) {
        auto next = frame.waiting.extract(frame.waiting.begin());
        run_block(frame, *frame.blocks[next.key()], std::move(next.mapped()));
    }
    if (frame.result) {
        for (const ObjectId id : frame.locals) {
            frame.result->state.memory.remove(id);
        }
    }
    return std::move(frame.result);
}

void Machine::run_block(Frame& frame, const llvm::BasicBlock& block, Arrival arrival) {
    if (++frame.visits[&block] > proof_.limits.visits) {
        throw Unknown{where_is(*block.getFirstNonPHI()) + ": a loop makes more than " +
                      std::to_string(proof_.limits.visits) + " passes, which is the limit"};
    }
    for (AnyPass& pass : frame.any_passes) {
        if (pass.loop.header == &block) {
            begin_any_pass(pass, arrival);
        }
    }
    for (const llvm::Instruction& instruction : block) {
        if (instruction.isTerminator()) {
            leave(frame, instruction, std::move(arrival));
            return;
        }
        if (!llvm::isa<llvm::PHINode>(instruction) && !run(frame, instruction, arrival)) {
            return;
        }
    }
}

bool Machine::run(Frame& frame, const llvm::Instruction& instruction, Arrival& arrival) {
    try {
        if (const auto* call = llvm::dyn_cast<llvm::CallBase>(&instruction)) {
            return run_call(frame, *call, arrival);
        }
        if (const auto* write = llvm::dyn_cast<llvm::StoreInst>(&instruction)) {
            store_value(*write, arrival);
        } else {
            arrival.values[&instruction] = evaluate(frame, instruction, arrival);
        }
        return true;
    } catch (const z3::exception& error) {
        throw Unknown{where_is(instruction) + ": z3: " + error.msg()};
    }
}

void Machine::leave(Frame& frame, const llvm::Instruction& terminator, Arrival arrival) {
    if (const auto* jump = llvm::dyn_cast<llvm::BranchInst>(&terminator)) {
        branch(frame, *jump, std::move(arrival));
    } else if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(&terminator)) {
        choose_case(frame, *choice, std::move(arrival));
    } else if (const auto* end = llvm::dyn_cast<llvm::ReturnInst>(&terminator)) {
        finish(frame, *end, arrival);
    } else if (llvm::isa<llvm::UnreachableInst>(terminator)) {
        proof_.obligations.add(arrival.state.path, proof_.context.bool_val(false), "this place is never reached",
                               where_is(terminator));
    } else {
        throw Unknown{where_is(terminator) + ": canproof prove does not support `" + terminator.getOpcodeName() + "`"};
    }
}

bool Machine::possible(const State& state, const Term& condition, unsigned milliseconds) {
    if (is_true(condition) || is_false(condition)) {
        return is_true(condition);
    }
    return proof_.solver.satisfiable(state.path, condition, milliseconds, Detail::outline) != Answer::no;
}

void Machine::branch(Frame& frame, const llvm::BranchInst& branch, Arrival arrival) {
    const llvm::BasicBlock& here = *branch.getParent();
    if (branch.isUnconditional()) {
        go(frame, here, *branch.getSuccessor(0), std::move(arrival));
        return;
    }
    const Term condition = as_truth(scalar(branch.getCondition(), arrival));
    const Term opposite = negated(condition);
    const bool repeats = frame.visits[&here] > 1;
    const unsigned time = repeats ? proof_.limits.loop_milliseconds : proof_.limits.branch_milliseconds;
    if (!possible(arrival.state, condition, time)) {
        go(frame, here, *branch.getSuccessor(1), std::move(arrival));
    } else if (!possible(arrival.state, opposite, time)) {
        go(frame, here, *branch.getSuccessor(0), std::move(arrival));
    } else {
        Arrival other = arrival;
        other.state.path.push_back(opposite);
        arrival.state.path.push_back(condition);
        go(frame, here, *branch.getSuccessor(0), std::move(arrival));
        go(frame, here, *branch.getSuccessor(1), std::move(other));
    }
}

void Machine::choose_case(Frame& frame, const llvm::SwitchInst& choice, Arrival arrival) {
    const Term value = as_bits(scalar(choice.getCondition(), arrival));
    std::map<const llvm::BasicBlock*, std::vector<Term>> targets;
    std::vector<const llvm::BasicBlock*> in_order;
    std::vector<Term> none;
    for (const auto& one : choice.cases()) {
        const Term label = as_bits(globals_.value(*one.getCaseValue()).front());
        const Term taken = (value == label).simplify();
        if (targets.find(one.getCaseSuccessor()) == targets.end()) {
            in_order.push_back(one.getCaseSuccessor());
        }
        targets[one.getCaseSuccessor()].push_back(taken);
        none.push_back(!taken);
    }
    const llvm::BasicBlock* otherwise = choice.getDefaultDest();
    if (targets.find(otherwise) == targets.end()) {
        in_order.push_back(otherwise);
    }
    targets[otherwise].push_back(all_of(proof_.context, none));
    for (const llvm::BasicBlock* target : in_order) {
        const Term condition = any_of(proof_.context, targets[target]);
        if (!possible(arrival.state, condition, proof_.limits.branch_milliseconds)) {
            continue;
        }
        Arrival there = arrival;
        if (!is_true(condition)) {
            there.state.path.push_back(condition);
        }
        go(frame, *choice.getParent(), *target, std::move(there));
    }
}

void Machine::go(Frame& frame, const llvm::BasicBlock& from, const llvm::BasicBlock& to, Arrival arrival) {
    std::vector<std::pair<const llvm::Value*, Value>>
        taken;  // reads all values before it sets one, because one phi instruction may use the result of another
    for (const llvm::PHINode& phi : to.phis()) {
        taken.emplace_back(&phi, operand(phi.getIncomingValueForBlock(&from), arrival));
    }
    for (auto& [phi, value] : taken) {
        arrival.values[phi] = std::move(value);
    }
    for (const AnyPass& pass : frame.any_passes) {
        if (pass.loop.repeats(from, to)) {
            end_any_pass(pass, from, arrival);
            return;
        }
    }
    const unsigned position = frame.order.at(&to);
    const auto waiting = frame.waiting.find(position);
    if (waiting == frame.waiting.end()) {
        frame.waiting.emplace(position, std::move(arrival));
    } else {
        join(waiting->second, arrival, to);
    }
}

bool Machine::is_usable(const llvm::Value& value, const llvm::BasicBlock& at) {
    const auto* instruction = llvm::dyn_cast<llvm::Instruction>(&value);
    if (instruction == nullptr || instruction->getParent() == &at) {
        return true;
    }
    auto known = dominators_.find(at.getParent());
    if (known == dominators_.end()) {
        known = dominators_.try_emplace(at.getParent(), const_cast<llvm::Function&>(*at.getParent())).first;
    }
    return known->second.dominates(instruction->getParent(), &at);
}

void Machine::join(Arrival& first, const Arrival& second, const llvm::BasicBlock& at) {
    const Term condition = merge(proof_.solver, proof_.objects, first.state, second.state);
    for (auto value = first.values.begin(); value != first.values.end();) {
        const auto other = second.values.find(value->first);
        if (other == second.values.end() || !is_usable(*value->first, at)) {
            value = first.values.erase(value);
            continue;
        }
        value->second = joined(condition, value->second, other->second, value->first);
        ++value;
    }
}

Value Machine::joined(const Term& condition, const Value& first, const Value& second, const llvm::Value* of) {
    Value all;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Term one = choose(condition, first[i], second[i]);
        const bool is_address = of->getType()->isPointerTy() && !same(first[i], second[i]);
        all.push_back(is_address ? address_at(proof_.context, places_of(one, proof_.objects.size())) : one);
    }
    return all;
}

void Machine::finish(Frame& frame, const llvm::ReturnInst& end, const Arrival& arrival) {
    const llvm::Value* returned = end.getReturnValue();
    Return here{arrival.state, returned == nullptr ? Value{} : operand(returned, arrival)};
    if (!frame.result) {
        frame.result = std::move(here);
        return;
    }
    const Term condition = merge(proof_.solver, proof_.objects, frame.result->state, here.state);
    if (returned != nullptr) {
        frame.result->value = joined(condition, frame.result->value, here.value, returned);
    }
}

}  // namespace canproof::host::prove
