// SPDX-License-Identifier: Apache-2.0
// Executes one pass of a loop for any number of passes before it, with the invariant that the harness states.
#include <algorithm>

#include "host/prove/harness.hpp"
#include "host/prove/machine.hpp"
#include "host/prove/machine_frame.hpp"
#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

const std::set<std::uint64_t> no_bytes{};

std::string place_of(const Loop& loop) {
    return where_is(*loop.header->getTerminator());
}

}  // namespace

std::vector<AnyPass> Machine::stated_loops(const llvm::Function& function) const {
    std::vector<AnyPass> all;
    for (const LoopRule& rule : proof_.loop_rules) {
        if (is_named(function, rule.function)) {
            all.push_back(AnyPass{&rule, outermost_loop(function, rule.number)});
        }
    }
    return all;
}

void Machine::begin_any_pass(AnyPass& pass, Arrival& arrival) {
    proof_.is_modular = true;
    State first = arrival.state;
    const Term none = constant(proof_.context, 0, address_width);
    const Term holds = invariant(pass, none, arrival.values, first);
    proof_.obligations.add(first.path, holds, "the invariant holds before the loop", place_of(pass.loop));

    pass.passes = proof_.fresh(address_width);
    open_phis(pass, arrival);
    open_memory(pass, arrival);
    arrival.state.path.push_back(z3::ule(*pass.passes, pass.rule->most));
    pass.before = arrival.state.memory;
    const Term assumed = invariant(pass, *pass.passes, arrival.values, arrival.state);
    arrival.state.path.push_back(assumed);
}

void Machine::open_phis(const AnyPass& pass, Arrival& arrival) {
    for (const llvm::PHINode& phi : pass.loop.header->phis()) {
        if (!phi.getType()->isIntegerTy()) {
            throw Unknown{place_of(pass.loop) + ": an invariant needs a loop whose variables are integers"};
        }
        Term& value = arrival.values.at(&phi).front();
        const unsigned width = bits_of(phi.getType());
        if (const auto step = step_of(phi, pass.loop)) {
            value = (value + resized(*pass.passes, width) * constant(proof_.context, *step, width)).simplify();
        } else {
            value = width == 1 ? as_truth(proof_.fresh(1)) : proof_.fresh(width);
        }
    }
}

void Machine::open_memory(AnyPass& pass, Arrival& arrival) {
    if (pass.rule->bytes != 0) {
        const Input opened =
            open_state(proof_, arrival.state, pass.rule->changed, pass.rule->bytes, place_of(pass.loop));
        const Place named = places_of(pass.rule->changed, proof_.objects.size()).front();
        const std::uint64_t first = number(named.offset).value_or(0);
        pass.named = named.object;
        for (std::uint64_t i = 0; i < opened.bytes.size(); ++i) {
            if (opened.bytes[i]) {  // a byte of an address keeps its value
                pass.open.insert(first + i);
            }
        }
    }
    for (const llvm::AllocaInst* object : pass.loop.own) {
        const ObjectId id = *places_of(arrival.values.at(object).front(), proof_.objects.size()).front().object;
        const auto bytes = number(proof_.objects[id].size).value_or(0);
        arrival.state.memory.set(id,
                                 CellContents::unknown(bytes, [this](unsigned width) { return proof_.fresh(width); }));
        pass.own.insert(id);
    }
}

void Machine::end_any_pass(const AnyPass& pass, const llvm::BasicBlock& last, const Arrival& arrival) {
    const std::string where = where_is(*last.getTerminator());
    check_changes(pass, arrival, where);
    State after = arrival.state;
    const Term more = z3::ult(*pass.passes, pass.rule->most);
    proof_.obligations.add(after.path, more, "the loop makes no more passes than stated", where);
    after.path.push_back(more);
    const Term next = (*pass.passes + constant(proof_.context, 1, address_width)).simplify();
    const Term holds = invariant(pass, next, arrival.values, after);
    proof_.obligations.add(after.path, holds, "the invariant holds again after a pass of the loop", where);
}

void Machine::check_changes(const AnyPass& pass, const Arrival& arrival, const std::string& where) {
    for (const ObjectId id : arrival.state.memory.changed_since(proof_.objects, pass.before)) {
        const ContentsPointer before = pass.before.contents(proof_.objects, id);
        const ContentsPointer after = arrival.state.memory.contents(proof_.objects, id);
        if (pass.own.count(id) == 0 && !same_except(before, after, id == pass.named ? pass.open : no_bytes)) {
            throw Unknown{where + ": the loop changes `" + proof_.objects[id].name +
                          "`, or an address in it, which its stated invariant does not name"};
        }
    }
}

Term Machine::invariant(const AnyPass& pass, const Term& passes, const Values& values, State& state) {
    const LoopRule& rule = *pass.rule;
    const llvm::Function* function = function_at(rule.holds);
    if (function == nullptr) {
        throw Unknown{place_of(pass.loop) + ": the invariant of the loop is no function"};
    }
    std::vector<Value> arguments{{rule.context}, {passes}};
    for (const std::string& name : rule.variables) {
        const llvm::PHINode* variable = variable_of(pass.loop, name);
        if (variable == nullptr) {
            throw Unknown{place_of(pass.loop) + ": the loop changes no local variable `" + name + "`"};
        }
        arguments.push_back({resized(as_bits(values.at(variable).front()), address_width)});
    }
    arguments.resize(function->arg_size(), {constant(proof_.context, 0, address_width)});
    std::optional<Return> back = call(*function, arguments, std::move(state));
    if (!back) {
        throw Unknown{place_of(pass.loop) + ": the assumptions of the invariant contradict each other"};
    }
    state = std::move(back->state);
    return as_truth(back->value.front()).simplify();
}

}  // namespace canproof::host::prove
