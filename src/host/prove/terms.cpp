// SPDX-License-Identifier: Apache-2.0
#include "host/prove/terms.hpp"

#include <algorithm>

namespace canproof::host::prove {

namespace {

constexpr unsigned longest_word = 64;
/// greatest depth of the search in a term; the bits of deeper parts count as unknown
constexpr unsigned deepest_look = 8;

KnownBits lowest(std::uint64_t bits, unsigned count) {
    const unsigned kept = std::min(count, longest_word);
    return {kept, kept == longest_word ? bits : bits & ((std::uint64_t{1} << kept) - 1)};
}

unsigned zeros_of(const KnownBits& known) {
    unsigned zeros = 0;
    while (zeros < known.count && ((known.bits >> zeros) & 1U) == 0) {
        ++zeros;
    }
    return zeros;
}

KnownBits known_product(const KnownBits& a, const KnownBits& b) {
    return lowest(a.bits * b.bits, std::min(a.count + zeros_of(b), b.count + zeros_of(a)));
}

/// Returns the lowest bits in which two sets of known bits agree.
KnownBits common(const KnownBits& a, const KnownBits& b) {
    unsigned count = 0;
    while (count < std::min(a.count, b.count) && ((a.bits ^ b.bits) >> count & 1U) == 0) {
        ++count;
    }
    return lowest(a.bits, count);
}

KnownBits known(const Term& term, unsigned depth) {
    if (const auto value = number(term)) {
        return lowest(*value, width_of(term));
    }
    if (!term.is_bv() || !term.is_app() || depth == deepest_look) {
        return {};
    }
    const auto argument = [&](unsigned at) { return known(term.arg(at), depth + 1); };
    switch (term.decl().decl_kind()) {
        case Z3_OP_BADD:
        case Z3_OP_BMUL: {
            KnownBits all = argument(0);
            for (unsigned i = 1; i < term.num_args(); ++i) {
                const KnownBits more = argument(i);
                all = term.decl().decl_kind() == Z3_OP_BMUL
                          ? known_product(all, more)
                          : lowest(all.bits + more.bits, std::min(all.count, more.count));
            }
            return lowest(all.bits, std::min(all.count, width_of(term)));
        }
        case Z3_OP_ITE:
            return common(argument(1), argument(2));
        case Z3_OP_CONCAT:
            return argument(term.num_args() - 1);
        case Z3_OP_ZERO_EXT:
        case Z3_OP_SIGN_EXT:
            return argument(0);
        default:
            return {};
    }
}

}  // namespace

bool same(const Term& a, const Term& b) {
    return z3::eq(a, b);
}

bool is_true(const Term& truth) {
    return truth.is_true();
}

bool is_false(const Term& truth) {
    return truth.is_false();
}

std::optional<std::uint64_t> number(const Term& term) {
    std::uint64_t value = 0;
    if (term.is_bv() && term.is_numeral() && term.is_numeral_u64(value)) {
        return value;
    }
    return std::nullopt;
}

unsigned width_of(const Term& term) {
    return term.is_bool() ? 1U : term.get_sort().bv_size();
}

Term constant(z3::context& context, std::uint64_t value, unsigned width) {
    return context.bv_val(value, width);
}

Term as_bits(const Term& term) {
    if (!term.is_bool()) {
        return term;
    }
    z3::context& context = term.ctx();
    return choose(term, constant(context, 1, 1), constant(context, 0, 1));
}

Term as_truth(const Term& term) {
    return term.is_bool() ? term : (term == constant(term.ctx(), 1, 1)).simplify();
}

Term resized(const Term& term, unsigned width) {
    const Term bits = as_bits(term);
    const unsigned now = width_of(bits);
    if (now == width) {
        return bits;
    }
    return (now > width ? bits.extract(width - 1, 0) : z3::zext(bits, width - now)).simplify();
}

Term byte_of(const Term& word, unsigned at) {
    if (at == 0 && width_of(word) == byte_width) {
        return word;
    }
    return word.extract(byte_width * (at + 1) - 1, byte_width * at).simplify();
}

KnownBits low_bits(const Term& term) {
    return known(term, 0);
}

Term choose(const Term& condition, const Term& a, const Term& b) {
    if (is_true(condition) || same(a, b)) {
        return a;
    }
    if (is_false(condition)) {
        return b;
    }
    if (a.is_bool()) {
        return z3::ite(condition, a, b).simplify();
    }
    return z3::ite(condition, a, b);
}

Term negated(const Term& truth) {
    if (is_true(truth) || is_false(truth)) {
        return truth.ctx().bool_val(is_false(truth));
    }
    return truth.is_not() ? truth.arg(0) : !truth;
}

Term all_of(z3::context& context, const std::vector<Term>& truths) {
    z3::expr_vector all{context};
    for (const Term& one : truths) {
        all.push_back(one);
    }
    return z3::mk_and(all).simplify();
}

Term any_of(z3::context& context, const std::vector<Term>& truths) {
    z3::expr_vector all{context};
    for (const Term& one : truths) {
        all.push_back(one);
    }
    return z3::mk_or(all).simplify();
}

}  // namespace canproof::host::prove
