#include "host/prove/terms.hpp"

namespace canproof::host::prove {

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
