// SPDX-License-Identifier: Apache-2.0
#include "host/prove/order.hpp"

#include <algorithm>

#include "host/prove/term_graph.hpp"

namespace canproof::host::prove {

namespace {

constexpr unsigned longest_sum = 64;   ///< greatest number of bits of the numbers whose ranges are computed
constexpr unsigned deepest_range = 4;  ///< greatest depth of the search in a term; a deeper part may have any value

/// The least and the greatest value that a term may have.
struct Range {
    Bits least{0};
    Bits greatest{0};
};

Bits greatest_of(unsigned width) {
    return (Bits{1} << width) - 1;
}

Range range_of(const Term& term, unsigned depth);

Range range_of_concatenation(const Term& term, unsigned depth) {
    Range all;
    for (unsigned i = 0; i < term.num_args(); ++i) {
        const unsigned width = width_of(term.arg(i));
        const Range part = range_of(term.arg(i), depth + 1);
        all = {(all.least << width) + part.least, (all.greatest << width) + part.greatest};
    }
    return all;
}

Range range_of_sum(const Term& term, unsigned depth) {
    Range all;
    for (unsigned i = 0; i < term.num_args(); ++i) {
        const Range part = range_of(term.arg(i), depth + 1);
        all = {all.least + part.least, all.greatest + part.greatest};
    }
    const Bits greatest = greatest_of(width_of(term));
    return all.greatest <= greatest ? all : Range{0, greatest};
}

Range range_of(const Term& term, unsigned depth) {
    if (const auto value = number(term)) {
        return {*value, *value};
    }
    const Range any{0, greatest_of(width_of(term))};
    if (!term.is_app() || depth == deepest_range) {
        return any;
    }
    switch (term.decl().decl_kind()) {
        case Z3_OP_CONCAT:
            return range_of_concatenation(term, depth);
        case Z3_OP_ZERO_EXT:
            return range_of(term.arg(0), depth + 1);
        case Z3_OP_ITE: {
            const Range one = range_of(term.arg(1), depth + 1);
            const Range other = range_of(term.arg(2), depth + 1);
            return {std::min(one.least, other.least), std::max(one.greatest, other.greatest)};
        }
        case Z3_OP_BADD:
            return range_of_sum(term, depth);
        default:
            return any;
    }
}

/// A number as the sum of a constant and of other summands. `overflows` means that the sum may be greater than the
/// greatest number of its width.
struct Sum {
    Bits fixed{0};
    std::vector<Term> summands{};
    bool overflows{false};
};

void add(Sum& sum, const Term& term, unsigned depth) {
    if (const auto value = number(term)) {
        sum.fixed += *value;
    } else if (term.is_app() && term.decl().decl_kind() == Z3_OP_BADD && depth < deepest_range) {
        for (unsigned i = 0; i < term.num_args(); ++i) {
            add(sum, term.arg(i), depth + 1);
        }
    } else {
        sum.summands.push_back(term);
    }
}

/// Returns the range of a sum, as a number without a limit of its width.
Range range_of(const Sum& sum) {
    Range all{sum.fixed, sum.fixed};
    for (const Term& one : sum.summands) {
        const Range part = range_of(one, 0);
        all = {all.least + part.least, all.greatest + part.greatest};
    }
    return all;
}

Sum sum_of(const Term& term) {
    Sum sum;
    add(sum, term, 0);
    sum.overflows = range_of(sum).greatest > greatest_of(width_of(term));
    return sum;
}

/// Removes the summands that both sums have.
void remove_common(Sum& a, Sum& b) {
    for (auto one = a.summands.begin(); one != a.summands.end();) {
        const auto other =
            std::find_if(b.summands.begin(), b.summands.end(), [&one](const Term& term) { return same(term, *one); });
        if (other == b.summands.end()) {
            ++one;
        } else {
            b.summands.erase(other);
            one = a.summands.erase(one);
        }
    }
}

/// Returns whether a <= b, where the ranges of the summands decide it.
std::optional<bool> decided(const Term& a, const Term& b) {
    if (width_of(a) > longest_sum) {
        return std::nullopt;
    }
    Sum left = sum_of(a);
    Sum right = sum_of(b);
    if (left.overflows || right.overflows) {
        return std::nullopt;
    }
    remove_common(left, right);
    const Range low = range_of(left);
    const Range high = range_of(right);
    if (low.greatest <= high.least) {
        return true;
    }
    return low.least > high.greatest ? std::optional{false} : std::nullopt;
}

}  // namespace

Term at_most(const Term& a, const Term& b) {
    const auto known = decided(a, b);
    return known ? a.ctx().bool_val(*known) : z3::ule(a, b).simplify();
}

Term less(const Term& a, const Term& b) {
    const auto known = decided(b, a);
    return known ? a.ctx().bool_val(!*known) : z3::ult(a, b).simplify();
}

}  // namespace canproof::host::prove
