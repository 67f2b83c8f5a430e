// SPDX-License-Identifier: Apache-2.0
#include "host/prove/float_outline.hpp"

#include <cstring>
#include <limits>

namespace canproof::host::prove {

namespace {

/// Returns the bits of the number 1.
Term one_of_width(const Term& number) {
    const bool is_float = width_of(number) == 32;
    return constant(number.ctx(), is_float ? 0x3F800000U : 0x3FF0000000000000U, width_of(number));
}

Term infinity_like(const Term& number) {
    return constant(number.ctx(), width_of(number) == 32 ? 0x7F800000U : 0x7FF0000000000000U, width_of(number));
}

template <typename Number, typename Word>
Bits joined_as(FloatJoin join, Bits a, Bits b) {
    static_assert(sizeof(Number) == sizeof(Word) && std::numeric_limits<Number>::is_iec559);
    const auto number_of = [](Bits bits) {
        const auto word = static_cast<Word>(bits);
        Number number{};
        std::memcpy(&number, &word, sizeof(number));
        return number;
    };
    const Number left = number_of(a);
    const Number right = number_of(b);
    const Number result = join == FloatJoin::sum       ? left + right
                          : join == FloatJoin::product ? left * right
                                                       : left / right;
    Word bits{};
    std::memcpy(&bits, &result, sizeof(bits));
    return bits;
}

Term opposite_signs(const Term& a, const Term& b) {
    return sign_of(a) != sign_of(b);
}

/// Returns the outline of a sum. The sum of two numbers of one sign has this sign, and is at least as great as both.
/// The sum of two numbers of opposite signs has the sign of the greater one and is at most as great; it is +0 when both
/// are equally great.
Term outline_of_sum(const Term& a, const Term& b, const Term& result) {
    const Term zero = constant(a.ctx(), 0, width_of(a));
    const Term of_a = magnitude_of(a);
    const Term of_b = magnitude_of(b);
    const Term of_result = magnitude_of(result);
    const Term grows = sign_of(result) == sign_of(a) && z3::uge(of_result, of_a) && z3::uge(of_result, of_b);
    const Term shrinks = z3::ite(of_a == of_b, result == zero,
                                 z3::ite(z3::ugt(of_a, of_b), sign_of(result) == sign_of(a) && z3::ule(of_result, of_a),
                                         sign_of(result) == sign_of(b) && z3::ule(of_result, of_b)));
    return z3::ite(opposite_signs(a, b), shrinks, grows) && z3::implies(of_a == zero, of_result == of_b) &&
           z3::implies(of_b == zero, of_result == of_a);
}

/// Returns the outline of a product: it is at most as great as `a` when `b` is at most 1, at least as great when `b` is
/// at least 1, and the other way round.
Term outline_of_product(const Term& a, const Term& b, const Term& result) {
    const Term one = one_of_width(a);
    const Term of_a = magnitude_of(a);
    const Term of_b = magnitude_of(b);
    const Term of_result = magnitude_of(result);
    return sign_of(result) == opposite_signs(a, b) && z3::implies(z3::ule(of_b, one), z3::ule(of_result, of_a)) &&
           z3::implies(z3::uge(of_b, one), z3::uge(of_result, of_a)) &&
           z3::implies(z3::ule(of_a, one), z3::ule(of_result, of_b)) &&
           z3::implies(z3::uge(of_a, one), z3::uge(of_result, of_b));
}

/// Returns the outline of a quotient: it is at most as great as `a` when `b` is at least 1, and at least as great when
/// `b` is at most 1.
Term outline_of_quotient(const Term& a, const Term& b, const Term& result) {
    const Term one = one_of_width(a);
    const Term of_b = magnitude_of(b);
    return sign_of(result) == opposite_signs(a, b) &&
           z3::implies(z3::uge(of_b, one), z3::ule(magnitude_of(result), magnitude_of(a))) &&
           z3::implies(z3::ule(of_b, one), z3::uge(magnitude_of(result), magnitude_of(a)));
}

}  // namespace

Bits joined_bits(FloatJoin join, unsigned width, Bits a, Bits b) {
    return width == 32 ? joined_as<float, std::uint32_t>(join, a, b) : joined_as<double, std::uint64_t>(join, a, b);
}

Bits double_bits(Bits integer, unsigned width) {
    __extension__ using SignedBits = __int128;
    const unsigned unused = 128 - width;
    const auto value = static_cast<double>(static_cast<SignedBits>(integer << unused) >> unused);
    std::uint64_t bits{};
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

Term outline_of_integer(const Term& integer, const Term& result) {
    constexpr std::uint64_t exponent_of_one = 1023;
    constexpr unsigned fraction = 52;
    z3::context& context = integer.ctx();
    const Term zero = constant(context, 0, width_of(integer));
    const Term size = magnitude_of(result);
    const Term most = constant(context, (exponent_of_one + width_of(integer) - 1) << fraction, width_of(result));
    return sign_of(result) == z3::slt(integer, zero) &&
           z3::ite(integer == zero, size == 0, z3::uge(size, one_of_width(result))) && z3::ule(size, most);
}

Term magnitude_of(const Term& number) {
    return z3::zext(number.extract(width_of(number) - 2, 0), 1);
}

Term sign_of(const Term& number) {
    const unsigned top = width_of(number) - 1;
    return as_truth(number.extract(top, top));
}

Term gives_nan(FloatJoin join, const Term& a, const Term& b) {
    const Term infinity = infinity_like(a);
    const Term zero = constant(a.ctx(), 0, width_of(a));
    const Term of_a = magnitude_of(a);
    const Term of_b = magnitude_of(b);
    const Term both_infinite = of_a == infinity && of_b == infinity;
    const Term no_number = z3::ugt(of_a, infinity) || z3::ugt(of_b, infinity);
    switch (join) {
        case FloatJoin::sum:
            return no_number || (both_infinite && opposite_signs(a, b));
        case FloatJoin::product:
            return no_number || (of_a == zero && of_b == infinity) || (of_a == infinity && of_b == zero);
        default:
            return no_number || both_infinite || (of_a == zero && of_b == zero);
    }
}

Term outline_of(FloatJoin join, const Term& a, const Term& b, const Term& result) {
    switch (join) {
        case FloatJoin::sum:
            return outline_of_sum(a, b, result);
        case FloatJoin::product:
            return outline_of_product(a, b, result);
        default:
            return outline_of_quotient(a, b, result);
    }
}

}  // namespace canproof::host::prove
