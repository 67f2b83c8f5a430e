// SPDX-License-Identifier: Apache-2.0
// Included before all other code of the program of mutants. schemata.py writes the operators and conditions of the
// firmware as calls of these functions. Each does what the original code does unless its mutant is chosen. In a
// constant expression, no mutant is ever chosen.
#pragma once

namespace canproof::mutants {

/// The number of the chosen mutant; 0 chooses none.
extern unsigned chosen;
/// While a test runs: for each mutant, whether it would have computed a different value. Null when this is not
/// recorded.
extern unsigned char* told;

inline bool is(const unsigned mutant) noexcept {
    return chosen == mutant;
}
inline void tell(const unsigned mutant, const bool differs) noexcept {
    if (told != nullptr && differs) {
        told[mutant] = 1U;
    }
}

/// Returns a condition. `mutant` makes it true, the next mutant makes it false.
template <typename T>
constexpr bool forced(const unsigned mutant, const T& condition) {
    const bool holds = static_cast<bool>(condition);
    if (__builtin_is_constant_evaluated()) {
        return holds;
    }
    tell(mutant, !holds);
    tell(mutant + 1U, holds);
    return is(mutant) || (holds && !is(mutant + 1U));
}

/// Returns `holds`, the value of a comparison `a OP b`. Its three mutants return true, false and `boundary`.
/// `boundary` is the comparison changed in equality, such as `a <= b` for `a < b`.
constexpr bool compared(const unsigned mutant, const bool holds, const bool boundary) {
    if (__builtin_is_constant_evaluated()) {
        return holds;
    }
    tell(mutant, !holds);
    tell(mutant + 1U, holds);
    tell(mutant + 2U, holds != boundary);
    return is(mutant) || (is(mutant + 2U) ? boundary : (holds && !is(mutant + 1U)));
}
template <typename A, typename B>
constexpr bool less(const unsigned mutant, const A& a, const B& b) {
    return compared(mutant, a < b, a <= b);
}
template <typename A, typename B>
constexpr bool less_equal(const unsigned mutant, const A& a, const B& b) {
    return compared(mutant, a <= b, a < b);
}
template <typename A, typename B>
constexpr bool greater(const unsigned mutant, const A& a, const B& b) {
    return compared(mutant, a > b, a >= b);
}
template <typename A, typename B>
constexpr bool greater_equal(const unsigned mutant, const A& a, const B& b) {
    return compared(mutant, a >= b, a > b);
}

/// Returns whether the chosen mutant turns this `&&` into `||`, or this `||` into `&&`. `a && b` is then computed as
/// `!(!a && !b)`, which equals `a || b`.
constexpr bool turned(const unsigned mutant) {
    if (__builtin_is_constant_evaluated()) {
        return false;
    }
    tell(mutant, true);
    return is(mutant);
}

/// Returns `value`, the result of `a OP b`. The mutant returns `other`, the result of another operator.
template <typename T, typename U>
constexpr T either(const unsigned mutant, const T value, const U other) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    tell(mutant, !(value == static_cast<T>(other)));
    return is(mutant) ? static_cast<T>(other) : value;
}
template <typename A, typename B>
constexpr auto plus(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a + b : either(mutant, a + b, a - b);
}
template <typename A, typename B>
constexpr auto minus(const unsigned mutant, const A& a, const B& b) {
    if constexpr (__is_pointer(A) && __is_pointer(B)) {
        return a - b;
    } else {
        return __builtin_is_constant_evaluated() ? a - b : either(mutant, a - b, a + b);
    }
}
template <typename A, typename B>
constexpr auto times(const unsigned mutant, const A& a, const B& b) {
    if (__builtin_is_constant_evaluated() || !static_cast<bool>(b)) {
        return a * b;  // a / b would divide by zero, so the mutant multiplies too
    }
    return either(mutant, a * b, a / b);
}
template <typename A, typename B>
constexpr auto over(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a / b : either(mutant, a / b, a * b);
}
template <typename A, typename B>
constexpr auto modulo(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a % b : either(mutant, a % b, a * b);
}
template <typename A, typename B>
constexpr auto left(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a << b : either(mutant, a << b, a >> b);
}
template <typename A, typename B>
constexpr auto right(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a >> b : either(mutant, a >> b, a << b);
}
template <typename A, typename B>
constexpr auto bit_and(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a & b : either(mutant, a & b, a | b);
}
template <typename A, typename B>
constexpr auto bit_or(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a | b : either(mutant, a | b, a & b);
}
template <typename A, typename B>
constexpr auto bit_xor(const unsigned mutant, const A& a, const B& b) {
    return __builtin_is_constant_evaluated() ? a ^ b : either(mutant, a ^ b, a | b);
}

/// Assigns `value` to `a`: `a OP= b` is computed as `a = a OP b` by the functions above.
template <typename A, typename V>
constexpr A& assigned(A& a, const V value) {
    a = static_cast<A>(value);
    return a;
}

/// Returns whether a statement is executed. The mutant omits the statement.
constexpr bool kept(const unsigned mutant) {
    if (__builtin_is_constant_evaluated()) {
        return true;
    }
    tell(mutant, true);
    return !is(mutant);
}

/// Returns which of `count` calls runs at this step. Mutant `first + n` swaps the calls n and n + 1.
constexpr unsigned ordered(const unsigned first, const unsigned step, const unsigned count) {
    if (__builtin_is_constant_evaluated()) {
        return step;
    }
    for (unsigned n = 0U; n + 1U < count; ++n) {
        tell(first + n, true);
        if (is(first + n) && ((step == n) || (step == n + 1U))) {
            return (step == n) ? n + 1U : n;
        }
    }
    return step;
}

/// Returns a literal, which the mutant increases by one.
template <typename T>
constexpr T zero(const unsigned mutant, const T value) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    tell(mutant, true);
    return is(mutant) ? static_cast<T>(value + 1) : value;
}
/// Returns a literal. The first mutant increases it by one, the next mutant decreases it by one.
template <typename T>
constexpr T literal(const unsigned mutant, const T value) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    tell(mutant + 1U, true);
    return is(mutant + 1U) ? static_cast<T>(value - 1) : zero(mutant, value);
}

/// Returns an index. The mutant returns 0.
template <typename T>
constexpr T index(const unsigned mutant, const T value) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    tell(mutant, value != T{});
    return is(mutant) ? T{} : value;
}

/// Returns the value of a variable. The mutant returns the value of another variable.
template <typename T, typename U>
constexpr T other(const unsigned mutant, const T& value, const U& another) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    if constexpr (__is_class(T)) {
        tell(mutant, value.us != another.us);
    } else {
        tell(mutant, !(value == another));
    }
    return is(mutant) ? another : value;
}

}  // namespace canproof::mutants
