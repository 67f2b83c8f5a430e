// SPDX-License-Identifier: Apache-2.0
#include "host/prove/globals.hpp"

#include <llvm/ADT/APInt.h>
#include <llvm/IR/GlobalAlias.h>
#include <llvm/IR/Operator.h>
#include <llvm/Support/raw_ostream.h>

#include "host/prove/layout.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

Term of_integer(z3::context& context, const llvm::APInt& value) {
    const unsigned width = value.getBitWidth();
    if (width == 1) {
        return context.bool_val(value.getBoolValue());
    }
    if (width <= 64) {
        return constant(context, value.getZExtValue(), width);
    }
    const unsigned low = 64;
    return z3::concat(of_integer(context, value.extractBits(width - low, low)),
                      of_integer(context, value.extractBits(low, 0)))
        .simplify();
}

std::string text_of(const llvm::Constant& constant) {
    std::string text;
    llvm::raw_string_ostream{text} << constant;
    return text;
}

}  // namespace

Value Globals::value(const llvm::Constant& constant) {
    llvm::Type* type = constant.getType();
    if (!type->isAggregateType()) {
        return {scalar(constant)};
    }
    Value all;
    const auto* record = llvm::dyn_cast<llvm::StructType>(type);
    const std::uint64_t count =
        record != nullptr ? record->getNumElements() : llvm::cast<llvm::ArrayType>(type)->getNumElements();
    for (unsigned i = 0; i < count; ++i) {
        const Value part = value(*constant.getAggregateElement(i));
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

Term Globals::scalar(const llvm::Constant& constant) {
    if (const auto* integer = llvm::dyn_cast<llvm::ConstantInt>(&constant)) {
        return of_integer(proof_.context, integer->getValue());
    }
    if (const auto* real = llvm::dyn_cast<llvm::ConstantFP>(&constant)) {
        return of_integer(proof_.context, real->getValueAPF().bitcastToAPInt());
    }
    if (llvm::isa<llvm::ConstantPointerNull>(constant)) {
        return prove::constant(proof_.context, 0, address_width);
    }
    if (const auto* alias = llvm::dyn_cast<llvm::GlobalAlias>(&constant)) {
        return scalar(*alias->getAliasee());
    }
    if (const auto* global = llvm::dyn_cast<llvm::GlobalValue>(&constant)) {
        return address_of(*global);
    }
    if (const auto* expression = llvm::dyn_cast<llvm::ConstantExpr>(&constant)) {
        return of_expression(*expression);
    }
    if (llvm::isa<llvm::UndefValue>(constant)) {
        const auto width = static_cast<unsigned>(layout_.getTypeSizeInBits(constant.getType()).getFixedValue());
        const Term any = proof_.fresh(width);
        return width == 1 ? as_truth(any) : any;
    }
    throw Unknown{"canproof prove does not support the constant `" + text_of(constant) +
                  "`, which is neither a number nor an address"};
}

Term Globals::of_expression(const llvm::ConstantExpr& expression) {
    if (const auto* place = llvm::dyn_cast<llvm::GEPOperator>(&expression)) {
        llvm::APInt offset{address_width, 0};
        if (place->accumulateConstantOffset(layout_, offset)) {
            const Term base = scalar(*llvm::cast<llvm::Constant>(place->getPointerOperand()));
            return (base + of_integer(proof_.context, offset)).simplify();
        }
    }
    if (expression.getOpcode() == llvm::Instruction::PtrToInt ||
        expression.getOpcode() == llvm::Instruction::IntToPtr) {
        const auto width = static_cast<unsigned>(layout_.getTypeSizeInBits(expression.getType()).getFixedValue());
        return resized(scalar(*expression.getOperand(0)), width);
    }
    throw Unknown{"canproof prove does not support the computed constant `" + text_of(expression) + "`"};
}

Term Globals::address_of(const llvm::GlobalValue& global) {
    const auto known = ids_.find(&global);
    return base_of(proof_.context, known == ids_.end() ? add(global) : known->second);
}

ObjectId Globals::add(const llvm::GlobalValue& global) {
    const auto number_of = [this](std::uint64_t value) { return constant(proof_.context, value, address_width); };
    if (const auto* function = llvm::dyn_cast<llvm::Function>(&global)) {
        const ObjectId id = proof_.objects.add({function->getName().str(), number_of(0), 16, false});
        ids_.emplace(&global, id);
        functions_.emplace(id, function);
        return id;
    }
    const auto* variable = llvm::dyn_cast<llvm::GlobalVariable>(&global);
    if (variable == nullptr || !variable->hasInitializer()) {
        throw Unknown{"`" + global.getName().str() + "` has no value in this program"};
    }
    const std::uint64_t size = layout_.getTypeAllocSize(variable->getValueType()).getFixedValue();
    const std::uint64_t alignment = layout_.getPreferredAlign(variable).value();
    std::vector<Cell> cells(size, Cell{constant(proof_.context, 0, byte_width), 0});
    const ObjectId id =
        proof_.objects.add({variable->getName().str(), number_of(size), alignment, !variable->isConstant()});
    ids_.emplace(&global, id);  // done before reading the initial value, which may contain the variable's own address
    fill(cells, 0, *variable->getInitializer());
    proof_.objects.initialise(id, std::make_shared<CellContents>(std::move(cells)));
    return id;
}

void Globals::fill(std::vector<Cell>& cells, std::uint64_t at, const llvm::Constant& constant) {
    if (constant.isZeroValue() && !constant.getType()->isPointerTy()) {
        return;  // all cells are zero already
    }
    if (!constant.getType()->isAggregateType()) {
        const auto bytes = static_cast<unsigned>(layout_.getTypeStoreSize(constant.getType()).getFixedValue());
        put_word(cells, at, resized(scalar(constant), byte_width * bytes));
        return;
    }
    if (auto* record = llvm::dyn_cast<llvm::StructType>(constant.getType())) {
        const llvm::StructLayout* places = layout_.getStructLayout(record);
        for (unsigned i = 0; i < record->getNumElements(); ++i) {
            fill(cells, at + places->getElementOffset(i).getFixedValue(), *constant.getAggregateElement(i));
        }
        return;
    }
    auto* array = llvm::cast<llvm::ArrayType>(constant.getType());
    const std::uint64_t step = layout_.getTypeAllocSize(array->getElementType()).getFixedValue();
    for (unsigned i = 0; i < array->getNumElements(); ++i) {
        fill(cells, at + i * step, *constant.getAggregateElement(i));
    }
}

const llvm::Function* Globals::function(ObjectId id) const {
    const auto found = functions_.find(id);
    return found == functions_.end() ? nullptr : found->second;
}

std::string Globals::text(const Term& address) {
    const std::vector<Place> places = places_of(address, proof_.objects.size());
    const auto offset = number(places.front().offset);
    if (places.size() != 1 || !places.front().object || !offset) {
        throw Unknown{"a text in a call of a harness function is not constant; write a literal"};
    }
    const auto* contents = dynamic_cast<const CellContents*>(proof_.objects[*places.front().object].initial.get());
    std::string text;
    for (std::uint64_t at = *offset; contents != nullptr && at < contents->cells().size(); ++at) {
        const auto letter = number(word_at(contents->cells(), at, 1));
        if (!letter || *letter == 0) {
            break;
        }
        text += static_cast<char>(*letter);
    }
    return text;
}

}  // namespace canproof::host::prove
