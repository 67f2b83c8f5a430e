// SPDX-License-Identifier: Apache-2.0
#include "host/prove/floats.hpp"

#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr unsigned float_width = 32;
constexpr unsigned double_width = 64;
constexpr unsigned half_width = 32;  ///< half of the bits of the widest integer that is converted

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

/// Returns an unsigned integer for a number that is not NaN. These integers have the same order as their numbers; -0
/// and +0 give the same integer.
Term order_of(const Term& number) {
    const unsigned width = width_of(number);
    const Term zero = constant(number.ctx(), 0, width);
    const Term sign_bit = constant(number.ctx(), std::uint64_t{1} << (width - 1), width);
    const Term one_zero = choose((magnitude_of(number) == zero).simplify(), zero, number);
    return one_zero ^ choose(sign_of(one_zero), ~zero, sign_bit);
}

Term is_nan(const Term& number) {
    const unsigned width = width_of(number);
    return z3::ugt(magnitude_of(number), constant(number.ctx(), infinity_of(width), width)).simplify();
}

Term is_below(const Term& a, const Term& b) {
    return (!is_nan(a) && !is_nan(b) && z3::ult(order_of(a), order_of(b))).simplify();
}

/// Returns whether z3 leaves this value unspecified, because it is the result of an operation without a defined result.
bool is_unspecified(const Term& value) {
    return value.is_app() && value.num_args() > 0 && value.decl().decl_kind() == Z3_OP_UNINTERPRETED;
}

/// Removes from a choice the alternatives that z3 leaves unspecified.
Term specified(const Term& value) {
    if (!value.is_ite()) {
        return value;
    }
    const Term otherwise = specified(value.arg(2));
    return is_unspecified(value.arg(1)) ? otherwise : z3::ite(value.arg(0), value.arg(1), otherwise);
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

Floats::Applied Floats::applied(const std::string& name, const std::vector<Term>& operands, const MakeTerm& make) {
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
        // the first formula defines the result; z3 leaves the bits of a NaN result open, and further formulas only say
        // that these bits form a NaN
        const Term definition = done.size() == 1 && done[0].size() > 0 ? done[0][0] : context_.bool_val(false);
        if (!definition.is_eq() || !same(definition.arg(0), result)) {
            throw Unknown{"z3 cannot reduce the floating-point operation `" + name + "` to operations on bits"};
        }
        const Term all = definition.arg(1);
        const bool may_fail = all.is_ite() && is_unspecified(all.arg(1));
        known = circuits_.emplace(name, Circuit{bits, may_fail ? all.arg(0) : context_.bool_val(false), specified(all)})
                    .first;
    }
    z3::expr_vector values{context_};
    for (const Term& one : operands) {
        values.push_back(one);
    }
    const auto with_operands = [&](Term term) { return term.substitute(known->second.inputs, values).simplify(); };
    return {with_operands(known->second.result), with_operands(known->second.fails)};
}

Term Floats::number_of(const std::string& name, const std::vector<Term>& operands, unsigned width,
                       const MakeTerm& make) {
    const std::string type = std::to_string(width) + "of" + std::to_string(width_of(operands.front()));
    const Applied done = applied(name + type, operands,
                                 [&make](const std::vector<Number>& inputs) { return make(inputs).mk_to_ieee_bv(); });
    return or_nan(done, width);
}

Term Floats::or_nan(const Applied& done, unsigned width) {
    const Term quiet = constant(context_, quiet_nan_of(width), width);
    return is_false(done.fails) ? done.value : choose(done.fails, fresh_(width) | quiet, done.value);
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

Term Floats::circuit_of(FloatJoin join, const Term& a, const Term& b) {
    using Make = Z3_ast (*)(Z3_context, Z3_ast rounding, Z3_ast a, Z3_ast b);
    const Make make = join == FloatJoin::sum       ? Z3_mk_fpa_add
                      : join == FloatJoin::product ? Z3_mk_fpa_mul
                                                   : Z3_mk_fpa_div;
    const std::string name = "join" + std::to_string(static_cast<unsigned>(join)) + "_" + std::to_string(width_of(a));
    return applied(name, {a, b},
                   [this, make](const auto& inputs) {
                       const Z3_ast even = Z3_mk_fpa_rne(context_);
                       return Term{context_, make(context_, even, inputs[0].value, inputs[1].value)}.mk_to_ieee_bv();
                   })
        .value;
}

Term Floats::named(FloatJoin join, const Term& a, const Term& b, const Term& fails) {
    const auto known = names_.find({join, a.id(), b.id()});
    if (known != names_.end()) {
        return known->second;
    }
    const unsigned width = width_of(a);
    const Term name = fresh_(width);
    solver_.define({name, a, b, [join, width](Bits left, Bits right) { return joined_bits(join, width, left, right); },
                    (fails || outline_of(join, a, b, name)).simplify(),
                    [this, join, a, b, name, fails] { return fails || name == circuit_of(join, a, b); }});
    return names_.emplace(std::tuple{join, a.id(), b.id()}, name).first->second;
}

Term Floats::joined(FloatJoin join, const Term& a, const Term& b) {
    const Term fails = gives_nan(join, a, b).simplify();
    const bool is_constant = number(a) && number(b);
    const Term value = is_constant || is_true(fails) ? circuit_of(join, a, b) : named(join, a, b, fails);
    return or_nan({value, fails}, width_of(a));
}

std::optional<Term> Floats::computed(const llvm::BinaryOperator& operation, const Term& a, const Term& b) {
    if (!is_modelled(*operation.getType())) {
        return std::nullopt;
    }
    switch (operation.getOpcode()) {
        case llvm::Instruction::FAdd:
            return joined(FloatJoin::sum, a, b);
        case llvm::Instruction::FSub:
            return joined(FloatJoin::sum, a, negated(b));  // z3 4.8.12 writes no circuit for a difference
        case llvm::Instruction::FMul:
            return joined(FloatJoin::product, a, b);
        case llvm::Instruction::FDiv:
            return joined(FloatJoin::quotient, a, b);
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
    // in an LLVM predicate, one bit each stands for equal, above, below and unordered
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

Term Floats::resized_number(const Term& from, unsigned width) {
    const Layout layout = layout_of(width);
    const z3::sort sort = context_.fpa_sort(layout.exponent, layout.fraction + 1);
    return number_of("resized", {from}, width, [&](const auto& inputs) {
        return Term{context_, Z3_mk_fpa_to_fp_float(context_, Z3_mk_fpa_rne(context_), inputs[0].value, sort)};
    });
}

/// z3 4.8.12 writes no circuit for an integer that must be rounded. So two halves are converted exactly, and only their
/// sum is rounded.
Term Floats::rounded_double(const Term& integer) {
    const auto upper = of_integer(integer.extract(width_of(integer) - 1, half_width).simplify(), double_width);
    const auto lower = of_integer(z3::zext(integer.extract(half_width - 1, 0), 1).simplify(), double_width);
    const Term scale = constant(context_, power_of_two(half_width, double_width), double_width);
    return circuit_of(FloatJoin::sum, circuit_of(FloatJoin::product, *upper, scale), *lower);
}

std::optional<Term> Floats::of_integer(const Term& integer, unsigned width) {
    const unsigned bits = width_of(integer);
    const Layout layout = layout_of(width);
    if (bits <= layout.fraction + 1) {  // every integer of this width is exact as a floating-point number
        const z3::sort sort = context_.fpa_sort(layout.exponent, layout.fraction + 1);
        return number_of("of_integer", {integer}, width, [&](const auto& inputs) {
            return Term{context_, Z3_mk_fpa_to_fp_signed(context_, Z3_mk_fpa_rne(context_), inputs[0].bits, sort)};
        });
    }
    if (width == double_width && bits <= 2 * half_width + 1) {
        const Term name = fresh_(width);
        solver_.define({name, integer, integer, [bits](Bits value, Bits) { return double_bits(value, bits); },
                        outline_of_integer(integer, name).simplify(),
                        [this, integer, name] { return name == rounded_double(integer); }});
        return name;
    }
    if (width == float_width && bits <= layout_of(double_width).fraction + 1) {
        return resized_number(*of_integer(integer, double_width), width);
    }
    return std::nullopt;
}

Computed Floats::to_integer(const Term& from, unsigned bits, bool is_signed) {
    const unsigned width = width_of(from);
    const Term whole = number_of("trunc", {from}, width, [this](const auto& inputs) {
        return Term{context_, Z3_mk_fpa_round_to_integral(context_, Z3_mk_fpa_rtz(context_), inputs[0].value)};
    });
    const Term end = constant(context_, power_of_two(is_signed ? bits - 1 : bits, width), width);
    const Term least = is_signed ? negated(end) : constant(context_, 0, width);
    const Term fits = (is_below(whole, end) && !is_below(whole, least)).simplify();
    // Converts to a signed integer with one bit more than the result. Such an integer contains each value that fits the
    // result, signed or unsigned.
    const std::string name = "to_integer" + std::to_string(bits) + "of" + std::to_string(width);
    const Applied integer = applied(name, {from}, [this, bits](const auto& inputs) {
        return Term{context_, Z3_mk_fpa_to_sbv(context_, Z3_mk_fpa_rtz(context_), inputs[0].value, bits + 1)};
    });
    return {integer.value.extract(bits - 1, 0).simplify(), fits};
}

std::optional<Computed> Floats::converted(const llvm::CastInst& cast, const Term& from) {
    const bool is_number = is_modelled(*cast.getType());
    const bool was_number = is_modelled(*cast.getSrcTy());
    const auto bits = static_cast<unsigned>(cast.getType()->getPrimitiveSizeInBits().getFixedValue());
    std::optional<Term> value;
    switch (cast.getOpcode()) {
        case llvm::Instruction::SIToFP:
        case llvm::Instruction::UIToFP: {
            // an additional sign bit makes each integer a signed one
            const Term plain = as_bits(from);
            const Term wide = cast.getOpcode() == llvm::Instruction::SIToFP ? z3::sext(plain, 1) : z3::zext(plain, 1);
            value = is_number ? of_integer(wide.simplify(), bits) : std::nullopt;
            break;
        }
        case llvm::Instruction::FPExt:
        case llvm::Instruction::FPTrunc:
            if (is_number && was_number) {
                value = resized_number(from, bits);
            }
            break;
        case llvm::Instruction::FPToSI:
        case llvm::Instruction::FPToUI:
            if (was_number && bits <= double_width) {
                return to_integer(from, bits, cast.getOpcode() == llvm::Instruction::FPToSI);
            }
            break;
        default:
            break;
    }
    return value ? std::optional<Computed>{Computed{*value, context_.bool_val(true)}} : std::nullopt;
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
    // when the operands are -0 and +0, the result may be either of them
    const Term either = order_of(a) == order_of(b) && as_truth(fresh_(1));
    return choose(is_nan(a), b, choose(is_nan(b), a, choose((first || either).simplify(), a, b)));
}

}  // namespace canproof::host::prove
