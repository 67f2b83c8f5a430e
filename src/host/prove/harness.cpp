// SPDX-License-Identifier: Apache-2.0
#include "host/prove/harness.hpp"

#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>

#include "host/prove/access.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::uint64_t most_input_bytes = 65536;
constexpr unsigned address_bytes = address_width / byte_width;

/// The object to which an address points, its cells, and the offset of the address, which must be a constant.
struct Target {
    ObjectId object;
    std::uint64_t offset;
    std::vector<Cell> cells;
};

Target target_of(const Proof& proof, const State& state, const Term& address, std::uint64_t bytes,
                 const std::string& where) {
    const std::vector<Place> places = places_of(address, proof.objects.size());
    const auto offset = number(places.front().offset);
    if (places.size() != 1 || !places.front().object || !offset || bytes > most_input_bytes) {
        throw Unknown{where +
                      ": the memory that gets any values must be inside one object, at a constant offset, and have at "
                      "most 65536 bytes"};
    }
    const ContentsPointer contents = state.memory.contents(proof.objects, *places.front().object);
    const auto* cells = dynamic_cast<const CellContents*>(contents.get());
    if (cells == nullptr || *offset + bytes > cells->cells().size()) {
        throw Unknown{where +
                      ": the memory that gets any values must be inside one object, at a constant offset, and have at "
                      "most 65536 bytes"};
    }
    return {*places.front().object, *offset, cells->cells()};
}

std::uint64_t size_argument(const HarnessCall& call) {
    const auto bytes = number(call.arguments[1]);
    if (!bytes) {
        throw Unknown{call.where + ": the size of the memory that gets any values must be a constant"};
    }
    return *bytes;
}

/// Lets the bytes at an address have any values.
void leave_open(Proof& proof, State& state, const HarnessCall& call) {
    const std::uint64_t bytes = size_argument(call);
    Target target = target_of(proof, state, call.arguments[0], bytes, call.where);
    Input input;
    for (std::uint64_t i = 0; i < bytes; ++i) {
        const Term byte = proof.fresh(byte_width);
        target.cells[target.offset + i] = Cell{byte, 0};
        input.bytes.emplace_back(byte);
    }
    state.memory.set(target.object, std::make_shared<CellContents>(std::move(target.cells)));
    proof.inputs.push_back(std::move(input));
}

bool holds_address(const Proof& proof, const std::vector<Cell>& cells, std::size_t at) {
    if (at + address_bytes > cells.size()) {
        return false;
    }
    for (const Place& one : places_of(word_at(cells, at, address_bytes), proof.objects.size())) {
        if (one.object) {
            return true;
        }
    }
    return false;
}

/// Makes new memory with any contents. The size may be any term. Adds the obligation that the size is at most 2^32
/// bytes.
Value any_memory(Proof& proof, State& state, const HarnessCall& call) {
    const Term size = call.arguments[0];
    const auto memory = std::make_shared<UnknownBytes>(
        [&proof](unsigned width) { return proof.fresh(width); },
        [&proof](const void* of, const Term& offset, const Term& value) { proof.solver.know_byte(of, offset, value); });
    const Term most = constant(proof.context, std::uint64_t{1} << 32U, address_width);
    proof.obligations.add(state.path, z3::ule(size, most), "memory of any size has at most 2^32 bytes", call.where);
    const ObjectId id = proof.objects.add({"memory of any size", size, 16, true});
    state.memory.set(id, memory);
    Input input;
    input.size = size;
    input.memory = memory;
    proof.inputs.push_back(std::move(input));
    return {base_of(proof.context, id)};
}

/// Returns the number that this call of each() returns in the current case of the theorem.
Value each(Proof& proof, const HarnessCall& call) {
    constexpr std::uint64_t most_cases = 256;
    const auto count = number(call.arguments[0]);
    if (!count || *count == 0 || *count > most_cases) {
        throw Unknown{call.where + ": the argument of each() must be a constant from 1 to 256"};
    }
    const Term chosen =
        constant(proof.context, proof.at.number(proof.each_calls, static_cast<unsigned>(*count)), byte_width);
    ++proof.each_calls;
    Input input;
    input.bytes.emplace_back(chosen);
    proof.inputs.push_back(std::move(input));
    return {chosen};
}

HarnessEffect assume(State& state, const Term& truth) {
    const Term plain = as_truth(truth).simplify();
    if (is_false(plain)) {
        return HarnessEffect::path_ends;
    }
    if (!is_true(plain)) {
        state.path.push_back(plain);
    }
    return HarnessEffect::goes_on;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream words{text};
    return {std::istream_iterator<std::string>{words}, {}};
}

/// Notes the invariant that the harness states for a loop of a function.
void note_loop_rule(Proof& proof, Globals& globals, const HarnessCall& call) {
    const auto loop = number(call.arguments[1]);
    const std::vector<std::string> variables = words_of(globals.text(call.arguments[2]));
    const auto bytes = number(call.arguments[5]);
    if (!loop || variables.size() > 2 || !bytes) {
        throw Unknown{call.where +
                      ": an invariant of a loop needs a constant number and size, and at most two variables"};
    }
    proof.loop_rules.push_back({globals.text(call.arguments[0]), *loop, variables, call.arguments[3], call.arguments[4],
                                *bytes, call.arguments[6], call.arguments[7]});
}

}  // namespace

Input open_state(Proof& proof, State& state, const Term& address, std::uint64_t bytes, const std::string& where) {
    Target target = target_of(proof, state, address, bytes, where);
    Input input;
    for (std::uint64_t i = 0; i < bytes;) {
        if (i % address_bytes == 0 && holds_address(proof, target.cells, target.offset + i)) {
            input.bytes.insert(input.bytes.end(), address_bytes, std::nullopt);
            i += address_bytes;
            continue;
        }
        const Term byte = proof.fresh(byte_width);
        proof.state_bytes.insert(byte.id());
        target.cells[target.offset + i] = Cell{byte, 0};
        input.bytes.emplace_back(byte);
        ++i;
    }
    state.memory.set(target.object, std::make_shared<CellContents>(std::move(target.cells)));
    return input;
}

HarnessEffect call_harness(Proof& proof, Globals& globals, State& state, HarnessCall& call) {
    const std::string& name = call.function;
    if (name.rfind("canproof_", 0) != 0) {
        return HarnessEffect::none;
    }
    if (name == "canproof_assume") {
        const std::string file = std::filesystem::path{globals.text(call.arguments[1])}.lexically_normal().string();
        proof.assumptions.insert(file + ":" + std::to_string(number(call.arguments[2]).value_or(0)));
        return assume(state, call.arguments[0]);
    }
    if (name == "canproof_claim") {
        const std::uint64_t line = number(call.arguments[1]).value_or(0);
        proof.obligations.add(state.path, as_truth(call.arguments[0]),
                              "the claim in line " + std::to_string(line) + " holds", call.where);
    } else if (name == "canproof_any") {
        leave_open(proof, state, call);
    } else if (name == "canproof_any_state") {
        proof.inputs.push_back(open_state(proof, state, call.arguments[0], size_argument(call), call.where));
    } else if (name == "canproof_each") {
        call.result = each(proof, call);
    } else if (name == "canproof_any_memory") {
        call.result = any_memory(proof, state, call);
    } else if (name == "canproof_loop") {
        note_loop_rule(proof, globals, call);
    } else if (name == "canproof_contract") {
        proof.contracts.push_back(
            {globals.text(call.arguments[0]), globals.text(call.arguments[1]), call.arguments[2]});
    } else if (name == "canproof_seed") {
        return HarnessEffect::goes_on;  // canproof_seed() has an effect in the native run only
    } else if (name == "canproof_shows") {
        proof.statement = globals.text(call.arguments[0]);
        proof.noted();
    } else if (name == "canproof_proves") {
        proof.requirements.push_back(globals.text(call.arguments[0]));
        proof.noted();
    } else {
        throw Unknown{call.where + ": `" + name + "` is no function that properties/proofs/support/proof.hpp declares"};
    }
    return HarnessEffect::goes_on;
}

}  // namespace canproof::host::prove
