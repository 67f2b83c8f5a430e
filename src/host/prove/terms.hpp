// SPDX-License-Identifier: Apache-2.0
// The terms of z3 (bit vectors and truth values), and helpers for them.
#pragma once

#include <z3++.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace canproof::host::prove {

/// A truth value, or a bit vector of 8, 16, 32, 64 … bits.
using Term = z3::expr;

constexpr unsigned byte_width = 8U;
constexpr unsigned address_width = 64U;

/// Returns whether `a` and `b` are the same node of z3. Different nodes can still have equal values.
bool same(const Term& a, const Term& b);
bool is_true(const Term& truth);
bool is_false(const Term& truth);
/// Returns the value of a bit-vector constant whose value fits in 64 bits; nothing for any other term.
std::optional<std::uint64_t> number(const Term& term);
/// Returns the number of bits of a term; a truth value has one.
unsigned width_of(const Term& term);

Term constant(z3::context& context, std::uint64_t value, unsigned width);
/// Converts a truth value to a bit vector of one bit; as_truth() converts it back. as_bits() leaves a bit vector
/// unchanged, and as_truth() leaves a truth value unchanged.
Term as_bits(const Term& term);
Term as_truth(const Term& term);
/// Converts a bit vector to another width: removes the upper bits, or adds zeros.
Term resized(const Term& term, unsigned width);
/// Returns byte number `at` of a word; byte 0 is the least significant one.
Term byte_of(const Term& word, unsigned at);
/// The lowest bits of a term that are the same for all values of its unknowns: `count` bits, at most 64, with the value
/// `bits`.
struct KnownBits {
    unsigned count{0};
    std::uint64_t bits{0};
};
/// Returns the lowest bits of a term that are known. For 8 * x + 3, these are the lowest three bits, with the value 3.
KnownBits low_bits(const Term& term);
/// Returns the term `condition ? a : b`. Returns `a` or `b` itself if the condition is constant or both are the same.
Term choose(const Term& condition, const Term& a, const Term& b);

/// Returns the opposite of a truth value. The opposite of an opposite is the same term again.
Term negated(const Term& truth);
Term all_of(z3::context& context, const std::vector<Term>& truths);
Term any_of(z3::context& context, const std::vector<Term>& truths);

}  // namespace canproof::host::prove
