// SPDX-License-Identifier: Apache-2.0
#include "host/prove/floats.hpp"

#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr unsigned float_width = 32;
constexpr unsigned double_width = 64;

/// The layout of a number of IEEE 754.
struct Layout {
    unsigned exponent;
    unsigned fraction;  ///< bits of the significand that are stored
};

Layout layout_of(unsigned width) {
    return width == float_width ? Layout{8, 23} : Layout{11, 52};
}

bool is_modelled(const llvm::Type& type) {
    return type.isFloatTy() || type.isDoubleTy();
}

std::uint64_t infinity_of(unsigned width) {
    const Layout layout = layout_of(width);
    return ((std::uint64_t{1} << layout.exponent) - 1) << layout.fraction;
}

std::uint64_t quiet_nan_of(unsigned width) {
    return infinity_of(width) | (std::uint64_t{1} << (layout_of(width).fraction - 1));
}

/// Returns the bits of 2^power, which is a normal number.
std::uint64_t power_of_two(unsigned power, unsigned width) {
    const Layout layout = layout_of(width);
    const std::uint64_t bias = (std::uint64_t{1} << (layout.exponent - 1)) - 1;
    return (bias + power) << layout.fraction;
}

Term magnitude_of(const Term& number) {
    const unsigned width = width_of(number);
    return z3::zext(number.extract(width - 2, 0), 1);
}

Term sign_of(const Term& number) {
    const unsigned width = width_of(number);
    return as_truth(number.extract(width - 1, width - 1));
}

/// Returns an integer with the order of the numbers, as long as none is NaN: -0 and +0 are equal.
Term order_of(const Term& number) {
    const Term magnitude = magnitude_of(number);
    return choose(sign_of(number), -magnitude, magnitude);
}

Term is_nan(const Term& number) {
    const unsigned width = width_of(number);
    return z3::ugt(magnitude_of(number), constant(number.ctx(), infinity_of(width), width)).simplify();
}

Term is_below(const Term& a, const Term& b) {
    return (!is_nan(a) && !is_nan(b) && order_of(a) < order_of(b)).simplify();
}

using Round = Z3_ast (*)(Z3_context);

/// Returns the rounding mode of an intrinsic that rounds to a whole number.
std::optional<Round> rounding_of(llvm::Intrinsic::ID function) {
    switch (function) {
        case llvm::Intrinsic::floor:
            return Z3_mk_fpa_rtn;
        case llvm::Intrinsic::ceil:
            return Z3_mk_fpa_rtp;
        case llvm::Intrinsic::trunc:
            return Z3_mk_fpa_rtz;
        case llvm::Intrinsic::round:
            return Z3_mk_fpa_rna;
        default:
            return std::nullopt;
    }
}

}  // namespace

Floats::Number Floats::input(unsigned at, unsigned width) const {
    const Term bits = context_.bv_const(("float_input" + std::to_string(at)).c_str(), width);
    if (width != float_width && width != double_width) {  // an integer
        return {bits, bits};
    }
    const Layout layout = layout_of(width);
    return {bits, bits.mk_from_ieee_bv(context_.fpa_sort(layout.exponent, layout.fraction + 1))};
}

Term Floats::applied(const std::string& name, const std::vector<Term>& operands, const MakeTerm& make) {
    auto known = circuits_.find(name);
    if (known == circuits_.end()) {
        std::vector<Number> inputs;
        z3::expr_vector bits{context_};
        for (const Term& one : operands) {
            inputs.push_back(input(static_cast<unsigned>(inputs.size()), width_of(one)));
            bits.push_back(inputs.back().bits);
        }
        const Term operation = make(inputs);
        const Term result = context_.bv_const("float_result", width_of(operation));
        z3::goal goal{context_};
        goal.add(result == operation);
        const z3::apply_result done = z3::tactic{context_, "fpa2bv"}(goal);
        const Term circuit = done.size() == 1 && done[0].size() == 1 ? done[0][0] : context_.bool_val(false);
        if (!circuit.is_eq() || !same(circuit.arg(0), result)) {
            throw Unknown{"z3 writes no circuit for the floating-point operation `" + name + "`"};
        }
        known = circuits_.emplace(name, Circuit{bits, circuit.arg(1)}).first;
    }
    z3::expr_vector values{context_};
    for (const Term& one : operands) {
        values.push_back(one);
    }
    Term result = known->second.result;
    return result.substitute(known->second.inputs, values).simplify();
}

Term Floats::number_of(const std::string& name, const std::vector<Term>& operands, unsigned width,
                       const MakeTerm& make) {
    const Term bits = applied(name + std::to_string(width) + "of" + std::to_string(width_of(operands.front())),
                              operands, [&make](const std::vector<Number>& inputs) {
                                  return z3::expr{make(inputs)}.mk_to_ieee_bv();
                              });
    const Term failed = is_nan(bits);
    if (is_false(failed)) {
        return bits;
    }
    const Term quiet = constant(context_, quiet_nan_of(width), width);
    return choose(failed, fresh_(width) | quiet, bits);  // a quiet NaN of any sign and payload
}

Term Floats::is_of_class(const Term& number, std::uint64_t classes) {
    const unsigned width = width_of(number);
    const Term magnitude = magnitude_of(number);
    const Term infinity = constant(context_, infinity_of(width), width);
    const Term quiet = constant(context_, quiet_nan_of(width), width);
    const Term least_normal = constant(context_, std::uint64_t{1} << layout_of(width).fraction, width);
    const Term is_zero = magnitude == constant(context_, 0, width);
    const Term is_normal = z3::uge(magnitude, least_normal) && z3::ult(magnitude, infinity);
    const Term is_subnormal = !is_zero && z3::ult(magnitude, least_normal);
    const Term negative = sign_of(number);
    const std::vector<Term> in_order{is_nan(number) && z3::ult(magnitude, quiet),
                                     z3::uge(magnitude, quiet),
                                     negative && magnitude == infinity,
                                     negative && is_normal,
                                     negative && is_subnormal,
                                     negative && is_zero,
                                     !negative && is_zero,
                                     !negative && is_subnormal,
                                     !negative && is_normal,
                                     !negative && magnitude == infinity};
    std::vector<Term> wanted;
    for (std::size_t i = 0; i < in_order.size(); ++i) {
        if (((classes >> i) & 1U) != 0) {
            wanted.push_back(in_order[i]);
        }
    }
    return any_of(context_, wanted);
}

std::optional<Term> Floats::computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b) {
    if (!is_modelled(*operation.getType())) {
        return std::nullopt;
    }
    const auto made = [&](Z3_ast (*make)(Z3_context, Z3_ast, Z3_ast, Z3_ast)) {
        return number_of(operation.getOpcodeName(), {a, b}, width_of(a), [this, make](const auto& inputs) {
            return Term{context_, make(context_, Z3_mk_fpa_rne(context_), inputs[0].value, inputs[1].value)};
        });
    };
    switch (operation.getOpcode()) {
        case llvm::Instruction::FAdd:
            return made(Z3_mk_fpa_add);
        case llvm::Instruction::FSub:
            return made(Z3_mk_fpa_sub);
        case llvm::Instruction::FMul:
            return made(Z3_mk_fpa_mul);
        case llvm::Instruction::FDiv:
            return made(Z3_mk_fpa_div);
        default:
            return std::nullopt;
    }
}

Term Floats::negated(const Term& number) const {
    const unsigned width = width_of(number);
    return (number ^ constant(context_, std::uint64_t{1} << (width - 1), width)).simplify();
}

std::optional<Term> Floats::compared(const llvm::FCmpInst& comparison, const Term& a, const Term& b) {
    if (!is_modelled(*comparison.getOperand(0)->getType())) {
        return std::nullopt;
    }
    using llvm::CmpInst;
    const Term unordered = is_nan(a) || is_nan(b);
    const Term below = is_below(a, b);
    const Term above = is_below(b, a);
    const Term equal = !unordered && order_of(a) == order_of(b);
    // a predicate has a bit each for equal, above, below and unordered
    const unsigned predicate = comparison.getPredicate();
    std::vector<Term> holds;
    if ((predicate & CmpInst::FCMP_OEQ) != 0) {
        holds.push_back(equal);
    }
    if ((predicate & CmpInst::FCMP_OGT) != 0) {
        holds.push_back(above);
    }
    if ((predicate & CmpInst::FCMP_OLT) != 0) {
        holds.push_back(below);
    }
    if ((predicate & CmpInst::FCMP_UNO) != 0) {
        holds.push_back(unordered);
    }
    return any_of(context_, holds);
}

std::optional<Computed> Floats::converted(const llvm::CastInst& cast, const Term& from) {
    const auto sort = [this](unsigned width) {
        const Layout layout = layout_of(width);
        return context_.fpa_sort(layout.exponent, layout.fraction + 1);
    };
    const Term always = context_.bool_val(true);
    const unsigned opcode = cast.getOpcode();
    const bool from_integer = opcode == llvm::Instruction::SIToFP || opcode == llvm::Instruction::UIToFP;
    const bool to_integer = opcode == llvm::Instruction::FPToSI || opcode == llvm::Instruction::FPToUI;
    if (from_integer && is_modelled(*cast.getType())) {
        const unsigned width = cast.getType()->getScalarSizeInBits();
        // a sign bit more makes each integer a signed one
        const Term integer = as_bits(from);
        const Term wide = opcode == llvm::Instruction::SIToFP ? z3::sext(integer, 1) : z3::zext(integer, 1);
        return Computed{applied("from_integer" + std::to_string(width) + "of" + std::to_string(width_of(wide)),
                                {wide.simplify()},
                                [&](const auto& inputs) {
                                    const Z3_ast number = Z3_mk_fpa_to_fp_signed(context_, Z3_mk_fpa_rne(context_),
                                                                                 inputs[0].bits, sort(width));
                                    return Term{context_, Z3_mk_fpa_to_ieee_bv(context_, number)};
                                }),
                        always};
    }
    if (!is_modelled(*cast.getSrcTy())) {
        return std::nullopt;
    }
    const unsigned width = width_of(from);
    if (opcode == llvm::Instruction::FPExt || opcode == llvm::Instruction::FPTrunc) {
        if (!is_modelled(*cast.getType())) {
            return std::nullopt;
        }
        const unsigned wanted = cast.getType()->getScalarSizeInBits();
        return Computed{number_of("resized", {from}, wanted,
                                  [&](const auto& inputs) {
                                      return Term{context_, Z3_mk_fpa_to_fp_float(context_, Z3_mk_fpa_rne(context_),
                                                                                  inputs[0].value, sort(wanted))};
                                  }),
                        always};
    }
    if (!to_integer) {
        return std::nullopt;
    }
    const bool is_signed = opcode == llvm::Instruction::FPToSI;
    const unsigned bits = cast.getType()->getIntegerBitWidth();
    const Term whole = number_of("trunc", {from}, width, [this](const auto& inputs) {
        return Term{context_, Z3_mk_fpa_round_to_integral(context_, Z3_mk_fpa_rtz(context_), inputs[0].value)};
    });
    const Term end = constant(context_, power_of_two(is_signed ? bits - 1 : bits, width), width);
    const Term least = is_signed ? negated(end) : constant(context_, 0, width);
    const Term fits = (is_below(whole, end) && !is_below(whole, least)).simplify();
    // one bit more than the result has, so that each value that fits is one of a signed integer
    const std::string name = "to_integer" + std::to_string(bits) + "of" + std::to_string(width);
    const Term integer = applied(name, {from}, [&](const auto& inputs) {
        return Term{context_, Z3_mk_fpa_to_sbv(context_, Z3_mk_fpa_rtz(context_), inputs[0].value, bits + 1)};
    });
    return Computed{integer.extract(bits - 1, 0).simplify(), fits};
}

std::optional<Term> Floats::computed(llvm::Intrinsic::ID function, const llvm::Type& type,
                                     const std::vector<Term>& arguments) {
    if (!is_modelled(type)) {
        return std::nullopt;
    }
    const unsigned width = width_of(arguments.front());
    if (const auto round = rounding_of(function)) {
        const std::string name = "round" + std::to_string(function) + "_";
        return number_of(name, {arguments.front()}, width, [&](const auto& inputs) {
            return Term{context_, Z3_mk_fpa_round_to_integral(context_, (*round)(context_), inputs[0].value)};
        });
    }
    if (function == llvm::Intrinsic::is_fpclass) {
        return is_of_class(arguments[0], number(arguments[1]).value_or(0));
    }
    if (function == llvm::Intrinsic::fabs) {
        return magnitude_of(arguments.front()).simplify();
    }
    if (function != llvm::Intrinsic::minnum && function != llvm::Intrinsic::maxnum) {
        return std::nullopt;
    }
    const Term& a = arguments[0];
    const Term& b = arguments[1];
    const Term first = function == llvm::Intrinsic::minnum ? is_below(a, b) : is_below(b, a);
    const Term either = order_of(a) == order_of(b) && as_truth(fresh_(1));  // of -0 and +0, one of the two
    return choose(is_nan(a), b, choose(is_nan(b), a, choose((first || either).simplify(), a, b)));
}

}  // namespace canproof::host::prove
