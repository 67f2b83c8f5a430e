// SPDX-License-Identifier: Apache-2.0
// Executes single instructions: what they compute, read and write.
#include <llvm/ADT/MapVector.h>
#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/Operator.h>

#include "host/prove/access.hpp"
#include "host/prove/arithmetic.hpp"
#include "host/prove/layout.hpp"
#include "host/prove/machine.hpp"
#include "host/prove/machine_frame.hpp"
#include "host/prove/place_in_source.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

unsigned Machine::bits_of(llvm::Type* type) const {
    return static_cast<unsigned>(layout_.getTypeSizeInBits(type).getFixedValue());
}

Value Machine::operand(const llvm::Value* value, const Arrival& arrival) {
    if (const auto* fixed = llvm::dyn_cast<llvm::Constant>(value)) {
        return globals_.value(*fixed);
    }
    return arrival.values.at(value);
}

Value Machine::evaluate(Frame& frame, const llvm::Instruction& instruction, Arrival& arrival) {
    if (const auto* made = llvm::dyn_cast<llvm::AllocaInst>(&instruction)) {
        return new_object(frame, *made, arrival);
    }
    if (const auto* read = llvm::dyn_cast<llvm::LoadInst>(&instruction)) {
        return load_value(*read, arrival);
    }
    if (const auto* place = llvm::dyn_cast<llvm::GetElementPtrInst>(&instruction)) {
        return address_of(*place, arrival);
    }
    if (const auto* comparison = llvm::dyn_cast<llvm::ICmpInst>(&instruction)) {
        return {compared(*comparison, arrival)};
    }
    if (const auto floating = evaluate_float(instruction, arrival)) {
        return {*floating};
    }
    if (const auto* choice = llvm::dyn_cast<llvm::SelectInst>(&instruction)) {
        return joined(as_truth(scalar(choice->getCondition(), arrival)), operand(choice->getTrueValue(), arrival),
                      operand(choice->getFalseValue(), arrival), &instruction);
    }
    if (const auto* frozen = llvm::dyn_cast<llvm::FreezeInst>(&instruction)) {
        return operand(frozen->getOperand(0), arrival);
    }
    if (const auto* taken = llvm::dyn_cast<llvm::ExtractValueInst>(&instruction)) {
        const Value whole = operand(taken->getAggregateOperand(), arrival);
        const ScalarRange range =
            scalars_at(taken->getAggregateOperand()->getType(), taken->getIndices().vec(), layout_);
        const auto first = whole.begin() + static_cast<std::ptrdiff_t>(range.first);
        return {first, first + static_cast<std::ptrdiff_t>(range.count)};
    }
    if (const auto* put = llvm::dyn_cast<llvm::InsertValueInst>(&instruction)) {
        Value whole = operand(put->getAggregateOperand(), arrival);
        const Value part = operand(put->getInsertedValueOperand(), arrival);
        const ScalarRange range = scalars_at(put->getType(), put->getIndices().vec(), layout_);
        for (std::size_t i = 0; i < range.count; ++i) {
            whole[range.first + i] = part[i];
        }
        return whole;
    }
    if (const auto* operation = llvm::dyn_cast<llvm::BinaryOperator>(&instruction)) {
        if (operation->getOpcode() == llvm::Instruction::Sub && bits_of(operation->getType()) == address_width &&
            !operation->hasNoSignedWrap() && !operation->hasNoUnsignedWrap()) {
            const auto between = difference(proof_, scalar(operation->getOperand(0), arrival),
                                            scalar(operation->getOperand(1), arrival));
            if (between) {
                return {*between};
            }
        }
        const auto done = prove::computed(*operation, scalar(operation->getOperand(0), arrival),
                                          scalar(operation->getOperand(1), arrival));
        if (done) {
            proof_.obligations.add(arrival.state.path, done->defined, "the result of an operation is defined",
                                   where_is(instruction));
            return {done->value};
        }
    }
    if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&instruction)) {
        const auto done = converted(*cast, scalar(cast->getOperand(0), arrival), bits_of(cast->getType()));
        if (done) {
            return {*done};
        }
    }
    throw Unknown{where_is(instruction) + ": canproof prove does not support `" + instruction.getOpcodeName() + "`"};
}

std::optional<Term> Machine::evaluate_float(const llvm::Instruction& instruction, const Arrival& arrival) {
    const auto argument = [&](unsigned at) { return scalar(instruction.getOperand(at), arrival); };
    if (const auto* comparison = llvm::dyn_cast<llvm::FCmpInst>(&instruction)) {
        return proof_.floats.compared(*comparison, argument(0), argument(1));
    }
    if (instruction.getOpcode() == llvm::Instruction::FNeg) {
        return proof_.floats.negated(argument(0));
    }
    if (const auto* operation = llvm::dyn_cast<llvm::BinaryOperator>(&instruction)) {
        return proof_.floats.computed(*operation, argument(0), argument(1));
    }
    if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&instruction)) {
        if (const auto done = proof_.floats.converted(*cast, argument(0))) {
            proof_.obligations.add(arrival.state.path, done->defined, "a number fits into the integer",
                                   where_is(instruction));
            return done->value;
        }
    }
    return std::nullopt;
}

Value Machine::new_object(Frame& frame, const llvm::AllocaInst& made, Arrival& arrival) {
    const auto size = made.getAllocationSize(layout_);
    if (!size) {
        throw Unknown{where_is(made) + ": canproof prove does not support an array of variable length"};
    }
    const std::uint64_t bytes = size->getFixedValue();
    const ObjectId id = proof_.objects.add(
        {made.getName().str(), constant(proof_.context, bytes, address_width), made.getAlign().value(), true});
    frame.locals.push_back(id);
    arrival.state.memory.set(id, CellContents::unknown(bytes, [this](unsigned width) { return proof_.fresh(width); }));
    return {base_of(proof_.context, id)};
}

Value Machine::load_value(const llvm::LoadInst& read, const Arrival& arrival) {
    const std::string where = where_is(read);
    if (!read.isSimple()) {
        throw Unknown{where + ": canproof prove does not support an atomic or volatile read"};
    }
    const Term address = scalar(read.getPointerOperand(), arrival);
    Value all;
    for (const Scalar& one : scalars_of(read.getType(), layout_)) {
        const auto bytes = static_cast<unsigned>(layout_.getTypeStoreSize(one.type).getFixedValue());
        const Term at =
            moved(proof_, arrival.state, address, constant(proof_.context, one.offset, address_width), true, where);
        const std::uint64_t alignment = one.offset == 0 ? read.getAlign().value() : 1;
        const Term word = load(proof_, arrival.state, at, bytes, {alignment, where});
        check_range(read, word, arrival);
        const unsigned width = bits_of(one.type);
        all.push_back(width == 1 ? as_truth(resized(word, 1)) : resized(word, width));
    }
    return all;
}

namespace {

/// A possible meaning of a value: under the condition `when`, it is `byte`, for which the harness allows any value.
struct OpenByte {
    Term when;
    Term byte;
};

/// Collects the bytes for which the harness allows any value and from which `value` is chosen while `when` is true.
void collect_inputs(const Proof& proof, const Term& value, const Term& when, std::vector<OpenByte>& found) {
    if (value.is_app() && value.decl().decl_kind() == Z3_OP_ITE) {
        collect_inputs(proof, value.arg(1), when && value.arg(0), found);
        collect_inputs(proof, value.arg(2), when && !value.arg(0), found);
    } else if (proof.state_bytes.count(value.id()) != 0) {
        found.push_back({when, value});
    }
}

}  // namespace

/// Treats the range (0 to 1) that LLVM states for a byte which is read as a bool. If the harness allows any value for
/// the byte, assumes that the byte is in this range. For every other byte, adds this as an obligation.
void Machine::check_range(const llvm::LoadInst& read, const Term& value, const Arrival& arrival) {
    const llvm::MDNode* range = read.getMetadata(llvm::LLVMContext::MD_range);
    if (range == nullptr || width_of(value) != byte_width) {
        return;
    }
    const llvm::ConstantRange bounds = llvm::getConstantRangeFromMetadata(*range);
    const auto limit = [this](const llvm::APInt& number) {
        return constant(proof_.context, number.getZExtValue(), byte_width);
    };
    const auto fits = [&](const Term& byte) {
        return z3::uge(byte, limit(bounds.getUnsignedMin())) && z3::ule(byte, limit(bounds.getUnsignedMax()));
    };
    std::vector<OpenByte> open;
    collect_inputs(proof_, value, proof_.context.bool_val(true), open);
    for (const OpenByte& one : open) {  // assumes the range only where the value is that byte
        proof_.solver.know(
            z3::implies(all_of(proof_.context, arrival.state.path) && one.when, fits(one.byte)).simplify());
    }
    const bool is_open = open.size() == 1 && same(open.front().byte, value);
    if (!is_open) {
        proof_.obligations.add(arrival.state.path, fits(value), "a byte that is read as a bool is 0 or 1",
                               where_is(read));
    }
}

void Machine::store_value(const llvm::StoreInst& write, Arrival& arrival) {
    const std::string where = where_is(write);
    if (!write.isSimple()) {
        throw Unknown{where + ": canproof prove does not support an atomic or volatile write"};
    }
    const Term address = scalar(write.getPointerOperand(), arrival);
    const Value value = operand(write.getValueOperand(), arrival);
    const std::vector<Scalar> scalars = scalars_of(write.getValueOperand()->getType(), layout_);
    for (std::size_t i = 0; i < scalars.size(); ++i) {
        const auto bytes = static_cast<unsigned>(layout_.getTypeStoreSize(scalars[i].type).getFixedValue());
        const Term at = moved(proof_, arrival.state, address,
                              constant(proof_.context, scalars[i].offset, address_width), true, where);
        const std::uint64_t alignment = scalars[i].offset == 0 ? write.getAlign().value() : 1;
        store(proof_, arrival.state, at, resized(value[i], byte_width * bytes), {alignment, where});
    }
}

Value Machine::address_of(const llvm::GetElementPtrInst& place, const Arrival& arrival) {
    llvm::MapVector<llvm::Value*, llvm::APInt> variable;
    llvm::APInt fixed{address_width, 0};
    if (!llvm::cast<llvm::GEPOperator>(place).collectOffset(layout_, address_width, variable, fixed)) {
        throw Unknown{where_is(place) + ": canproof prove does not support an address other than a base and an offset"};
    }
    Term offset = constant(proof_.context, fixed.getZExtValue(), address_width);
    for (const auto& [index, step] : variable) {
        const Term times = as_bits(scalar(index, arrival));
        const Term wide = width_of(times) < address_width ? z3::sext(times, address_width - width_of(times)) : times;
        offset = offset + wide * constant(proof_.context, step.getZExtValue(), address_width);
    }
    return {moved(proof_, arrival.state, scalar(place.getPointerOperand(), arrival), offset.simplify(),
                  place.isInBounds(), where_is(place))};
}

Term Machine::compared(const llvm::ICmpInst& comparison, const Arrival& arrival) {
    const Term a = scalar(comparison.getOperand(0), arrival);
    const Term b = scalar(comparison.getOperand(1), arrival);
    const llvm::CmpInst::Predicate predicate = comparison.getPredicate();
    if (!comparison.getOperand(0)->getType()->isPointerTy()) {
        const auto done = prove::compared(predicate, a, b);
        if (done) {
            return *done;
        }
        throw Unknown{where_is(comparison) + ": canproof prove does not support this comparison"};
    }
    switch (predicate) {
        case llvm::CmpInst::ICMP_EQ:
            return equal_addresses(proof_, a, b);
        case llvm::CmpInst::ICMP_NE:
            return (!equal_addresses(proof_, a, b)).simplify();
        case llvm::CmpInst::ICMP_ULT:
            return below(proof_, a, b);
        case llvm::CmpInst::ICMP_UGT:
            return below(proof_, b, a);
        case llvm::CmpInst::ICMP_ULE:
            return (!below(proof_, b, a)).simplify();
        case llvm::CmpInst::ICMP_UGE:
            return (!below(proof_, a, b)).simplify();
        default:
            throw Unknown{where_is(comparison) + ": canproof prove does not support this comparison of addresses"};
    }
}

}  // namespace canproof::host::prove
