// SPDX-License-Identifier: Apache-2.0
#include "host/prove/arithmetic.hpp"

#include <llvm/IR/Operator.h>

#include "host/prove/order.hpp"

namespace canproof::host::prove {

namespace {

Term yes(const Term& of) {
    return of.ctx().bool_val(true);
}
Term zero(const Term& like) {
    return constant(like.ctx(), 0, width_of(like));
}

Term plain(Operation operation, const Term& a, const Term& b) {
    switch (operation) {
        case Operation::add:
            return a + b;
        case Operation::subtract:
            return a - b;
        default:
            return a * b;
    }
}

Term widened(const Term& term, unsigned by, bool is_signed) {
    return is_signed ? z3::sext(term, by) : z3::zext(term, by);
}

/// Returns the result of an addition, subtraction or multiplication. It is defined only if no overflow occurs that the
/// flags of the instruction exclude ("no signed wrap", "no unsigned wrap").
Computed flagged(const llvm::BinaryOperator& instruction, Operation operation, const Term& a, const Term& b) {
    const auto* flags = llvm::cast<llvm::OverflowingBinaryOperator>(&instruction);
    Term defined = yes(a);
    if (flags->hasNoSignedWrap()) {
        defined = defined && checked(operation, a, b, true).exact;
    }
    if (flags->hasNoUnsignedWrap()) {
        defined = defined && checked(operation, a, b, false).exact;
    }
    return {plain(operation, a, b).simplify(), defined.simplify()};
}

Computed divided(unsigned opcode, const Term& a, const Term& b) {
    const Term by_something = b != zero(b);
    const Term least = z3::shl(constant(a.ctx(), 1, width_of(a)), static_cast<int>(width_of(a)) - 1).simplify();
    const Term fits = !(a == least && b == ~zero(b));
    switch (opcode) {
        case llvm::Instruction::UDiv:
            return {z3::udiv(a, b).simplify(), by_something};
        case llvm::Instruction::URem:
            return {z3::urem(a, b).simplify(), by_something};
        case llvm::Instruction::SDiv:
            return {(a / b).simplify(), by_something && fits};
        default:
            return {z3::srem(a, b).simplify(), by_something && fits};
    }
}

Computed shifted(unsigned opcode, const Term& a, const Term& b) {
    const Term less = z3::ult(b, constant(b.ctx(), width_of(b), width_of(b)));
    switch (opcode) {
        case llvm::Instruction::Shl:
            return {z3::shl(a, b).simplify(), less};
        case llvm::Instruction::LShr:
            return {z3::lshr(a, b).simplify(), less};
        default:
            return {z3::ashr(a, b).simplify(), less};
    }
}

std::optional<Computed> of_truths(unsigned opcode, const Term& a, const Term& b) {
    switch (opcode) {
        case llvm::Instruction::And:
            return Computed{(a && b).simplify(), yes(a)};
        case llvm::Instruction::Or:
            return Computed{(a || b).simplify(), yes(a)};
        case llvm::Instruction::Xor:
        case llvm::Instruction::Add:
        case llvm::Instruction::Sub:
            return Computed{(a != b).simplify(), yes(a)};
        default:
            return std::nullopt;
    }
}

Term counted_ones(const Term& word) {
    Term sum = zero(word);
    for (unsigned bit = 0; bit < width_of(word); ++bit) {
        sum = sum + resized(word.extract(bit, bit), width_of(word));
    }
    return sum;
}

/// Returns the number of 0 bits before the first 1 bit. Counts from the highest bit if `from_top` is true, otherwise
/// from the lowest. Returns the width of the word when it has no 1 bit.
Term zeros_before(const Term& word, bool from_top) {
    const unsigned width = width_of(word);
    Term count = constant(word.ctx(), width, width);
    for (unsigned i = width; i > 0; --i) {
        const unsigned zeros = i - 1;
        const unsigned bit = from_top ? width - 1 - zeros : zeros;
        count = choose(as_truth(word.extract(bit, bit)), constant(word.ctx(), zeros, width), count);
    }
    return count;
}

Term bytes_reversed(const Term& word) {
    Term reversed = byte_of(word, 0);
    for (unsigned i = 1; i < width_of(word) / byte_width; ++i) {
        reversed = z3::concat(reversed, byte_of(word, i));
    }
    return reversed;
}

/// Returns the result of a funnel shift: `high` and `low` are put side by side and shifted by `by` modulo the width of
/// one word. After a shift to the left, the result is the upper word; after a shift to the right, the lower word.
Term funnel(const Term& high, const Term& low, const Term& by, bool left) {
    const unsigned width = width_of(high);
    const Term amount = z3::zext(z3::urem(by, constant(by.ctx(), width, width)), width);
    const Term both = z3::concat(high, low);
    return left ? z3::shl(both, amount).extract(2 * width - 1, width) : z3::lshr(both, amount).extract(width - 1, 0);
}

}  // namespace

Checked checked(Operation operation, const Term& a, const Term& b, bool is_signed) {
    const unsigned more = operation == Operation::multiply ? width_of(a) : 1U;
    const Term value = plain(operation, a, b).simplify();
    const Term wide = plain(operation, widened(a, more, is_signed), widened(b, more, is_signed));
    return {value, (wide == widened(value, more, is_signed)).simplify()};
}

std::optional<Computed> computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b) {
    if (operation.getType()->isFPOrFPVectorTy()) {
        return std::nullopt;
    }
    if (a.is_bool()) {
        return of_truths(operation.getOpcode(), a, b);
    }
    switch (operation.getOpcode()) {
        case llvm::Instruction::Add:
            return flagged(operation, Operation::add, a, b);
        case llvm::Instruction::Sub:
            return flagged(operation, Operation::subtract, a, b);
        case llvm::Instruction::Mul:
            return flagged(operation, Operation::multiply, a, b);
        case llvm::Instruction::And:
            return Computed{(a & b).simplify(), yes(a)};
        case llvm::Instruction::Or:
            return Computed{(a | b).simplify(), yes(a)};
        case llvm::Instruction::Xor:
            return Computed{(a ^ b).simplify(), yes(a)};
        case llvm::Instruction::UDiv:
        case llvm::Instruction::URem:
        case llvm::Instruction::SDiv:
        case llvm::Instruction::SRem:
            return divided(operation.getOpcode(), a, b);
        case llvm::Instruction::Shl:
        case llvm::Instruction::LShr:
        case llvm::Instruction::AShr:
            return shifted(operation.getOpcode(), a, b);
        default:
            return std::nullopt;
    }
}

std::optional<Term> compared(llvm::CmpInst::Predicate predicate, const Term& left, const Term& right) {
    if (predicate == llvm::CmpInst::ICMP_EQ) {
        return (left == right).simplify();
    }
    if (predicate == llvm::CmpInst::ICMP_NE) {
        return (left != right).simplify();
    }
    const Term a = as_bits(left);
    const Term b = as_bits(right);
    switch (predicate) {
        case llvm::CmpInst::ICMP_ULT:
            return less(a, b);
        case llvm::CmpInst::ICMP_ULE:
            return at_most(a, b);
        case llvm::CmpInst::ICMP_UGT:
            return less(b, a);
        case llvm::CmpInst::ICMP_UGE:
            return at_most(b, a);
        case llvm::CmpInst::ICMP_SLT:
            return (a < b).simplify();
        case llvm::CmpInst::ICMP_SLE:
            return (a <= b).simplify();
        case llvm::CmpInst::ICMP_SGT:
            return (a > b).simplify();
        case llvm::CmpInst::ICMP_SGE:
            return (a >= b).simplify();
        default:
            return std::nullopt;
    }
}

std::optional<Term> converted(const llvm::CastInst& cast, const Term& from, unsigned width) {
    const auto fitted = [width](const Term& bits) { return width == 1 ? as_truth(bits) : bits; };
    switch (cast.getOpcode()) {
        case llvm::Instruction::Trunc:
            return fitted(resized(from, width));
        case llvm::Instruction::ZExt:
            return resized(from, width);
        case llvm::Instruction::SExt: {
            const Term bits = as_bits(from);
            return z3::sext(bits, width - width_of(bits)).simplify();
        }
        case llvm::Instruction::BitCast:
        case llvm::Instruction::PtrToInt:
        case llvm::Instruction::IntToPtr:
            return width == width_of(from) ? from : fitted(resized(from, width));
        default:
            return std::nullopt;
    }
}

std::optional<Computed> computed(llvm::Intrinsic::ID function, const std::vector<Term>& all) {
    const Term a = as_bits(all[0]);
    const auto of = [&a](const Term& value) { return Computed{value.simplify(), yes(a)}; };
    switch (function) {
        case llvm::Intrinsic::umin:
            return of(z3::ite(z3::ult(a, all[1]), a, all[1]));
        case llvm::Intrinsic::umax:
            return of(z3::ite(z3::ugt(a, all[1]), a, all[1]));
        case llvm::Intrinsic::smin:
            return of(z3::ite(a < all[1], a, all[1]));
        case llvm::Intrinsic::smax:
            return of(z3::ite(a > all[1], a, all[1]));
        case llvm::Intrinsic::abs:
            return of(z3::ite(a < zero(a), -a, a));
        case llvm::Intrinsic::ctpop:
            return of(counted_ones(a));
        case llvm::Intrinsic::ctlz:
            return of(zeros_before(a, true));
        case llvm::Intrinsic::cttz:
            return of(zeros_before(a, false));
        case llvm::Intrinsic::bswap:
            return of(bytes_reversed(a));
        case llvm::Intrinsic::fshl:
            return of(funnel(a, all[1], all[2], true));
        case llvm::Intrinsic::fshr:
            return of(funnel(a, all[1], all[2], false));
        default:
            return std::nullopt;
    }
}

}  // namespace canproof::host::prove
