// SPDX-License-Identifier: Apache-2.0
// Carries out calls: of harness functions, of intrinsics, and of other functions by name or by address.
#include <llvm/IR/InstrTypes.h>

#include "host/prove/access.hpp"
#include "host/prove/harness.hpp"
#include "host/prove/intrinsics.hpp"
#include "host/prove/machine.hpp"
#include "host/prove/machine_frame.hpp"
#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

std::vector<Value> Machine::arguments_of(Frame& frame, const llvm::CallBase& call, Arrival& arrival) {
    std::vector<Value> all;
    for (unsigned i = 0; i < call.arg_size(); ++i) {
        Value value = operand(call.getArgOperand(i), arrival);
        if (call.isByValArgument(i)) {  // the called function gets its own copy of the argument
            const std::uint64_t size = layout_.getTypeAllocSize(call.getParamByValType(i)).getFixedValue();
            const Term bytes = constant(proof_.context, size, address_width);
            const ObjectId id = proof_.objects.add({"an argument", bytes, 16, true});
            arrival.state.memory.set(
                id, CellContents::unknown(size, [this](unsigned width) { return proof_.fresh(width); }));
            frame.locals.push_back(id);
            const Term copied_to = base_of(proof_.context, id);
            copy(proof_, arrival.state, copied_to, value.front(), bytes, where_is(call));
            value = {copied_to};
        }
        all.push_back(std::move(value));
    }
    return all;
}

bool Machine::run_call(Frame& frame, const llvm::CallBase& call, Arrival& arrival) {
    const auto* callee = llvm::dyn_cast<llvm::Function>(call.getCalledOperand()->stripPointerCastsAndAliases());
    const bool is_text = callee != nullptr && callee->isIntrinsic() && callee->getName().starts_with("llvm.dbg");
    if (is_text) {
        return true;
    }
    const std::vector<Value> arguments = arguments_of(frame, call, arrival);
    if (callee == nullptr) {
        return call_address(call, arguments, arrival);
    }
    if (!callee->isDeclaration()) {
        return call_function(call, *callee, arguments, arrival);
    }
    Value scalars;
    for (const Value& one : arguments) {
        scalars.insert(scalars.end(), one.begin(), one.end());
    }
    HarnessCall harness{callee->getName().str(), scalars, where_is(call)};
    const HarnessEffect effect = call_harness(proof_, globals_, arrival.state, harness);
    if (effect != HarnessEffect::none) {
        arrival.values[&call] = harness.result;
        return effect == HarnessEffect::goes_on;
    }
    Value result;
    switch (call_intrinsic(proof_, arrival.state, call, scalars, result)) {
        case CallEffect::goes_on:
            arrival.values[&call] = std::move(result);
            return true;
        case CallEffect::path_ends:
            return false;
        default:
            throw Unknown{where_is(call) + ": `" + readable_name(*callee) +
                          "` has no body here, and canproof prove does not know this function"};
    }
}

bool Machine::call_function(const llvm::CallBase& call_here, const llvm::Function& callee,
                            const std::vector<Value>& arguments, Arrival& arrival) {
    std::optional<Return> back = call(executed(callee), arguments, std::move(arrival.state));
    if (!back) {
        return false;
    }
    arrival.state = std::move(back->state);
    arrival.values[&call_here] = std::move(back->value);
    return true;
}

const llvm::Function* Machine::function_at(const Term& address) const {
    const auto object = places_of(address, proof_.objects.size()).front().object;
    return object ? globals_.function(*object) : nullptr;
}

const llvm::Function& Machine::executed(const llvm::Function& function) {
    for (auto contract = proof_.contracts.rbegin(); contract != proof_.contracts.rend(); ++contract) {
        if (is_named(function, contract->function)) {
            const llvm::Function* stands_for = function_at(contract->stands_for);
            if (stands_for == nullptr || stands_for->getFunctionType() != function.getFunctionType()) {
                throw Unknown{"the contract of " + contract->function + " needs a function with the same parameters"};
            }
            proof_.is_modular = true;
            proof_.used_theorems.insert(contract->theorem);
            return *stands_for;
        }
    }
    return function;
}

bool Machine::call_address(const llvm::CallBase& call_here, const std::vector<Value>& arguments, Arrival& arrival) {
    const Term address = scalar(call_here.getCalledOperand(), arrival);
    std::optional<Return> all;
    std::vector<Term> known;
    const State before = arrival.state;
    for (const Place& place : places_of(address, proof_.objects.size())) {
        const llvm::Function* callee = place.object ? globals_.function(*place.object) : nullptr;
        if (callee == nullptr || callee->isDeclaration() ||
            !possible(before, place.when, proof_.limits.branch_milliseconds)) {
            continue;
        }
        known.push_back(place.when);
        State there = before;
        if (!is_true(place.when)) {
            there.path.push_back(place.when);
        }
        std::optional<Return> back = call(executed(*callee), arguments, std::move(there));
        if (back && all) {
            const Term condition = merge(proof_.solver, proof_.objects, all->state, back->state);
            all->value = joined(condition, all->value, back->value, &call_here);
        } else if (back) {
            all = std::move(back);
        }
    }
    proof_.obligations.add(before.path, any_of(proof_.context, known), "a call reaches a function with a body",
                           where_is(call_here));
    if (!all) {
        return false;
    }
    arrival.state = std::move(all->state);
    arrival.values[&call_here] = std::move(all->value);
    return true;
}

}  // namespace canproof::host::prove
