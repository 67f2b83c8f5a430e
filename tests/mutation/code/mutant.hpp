// Included before everything else in the program of mutants: what the operators and conditions of the firmware are
// written as there (see schemata.py). Each does what stood in its place, unless its mutant is chosen. In a constant
// expression none ever is.
#pragma once

namespace canproof::mutants {

/// The chosen mutant; 0: none.
extern unsigned chosen;
/// While a test runs: by mutant, whether it would have computed something else. Null when nobody asks.
extern unsigned char* told;

inline bool is(const unsigned mutant) noexcept {
    return chosen == mutant;
}
inline void tell(const unsigned mutant, const bool differs) noexcept {
    if (told != nullptr && differs) {
        told[mutant] = 1U;
    }
}

/// A condition: `mutant` makes it true, the next one false.
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

/// A comparison `a OP b` whose value is `holds`; the third mutant has `boundary`: what it is with equality moved.
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

/// Turns `&&` into `||` and back: not(not a and not b) is a or b.
constexpr bool turned(const unsigned mutant) {
    if (__builtin_is_constant_evaluated()) {
        return false;
    }
    tell(mutant, true);
    return is(mutant);
}

/// `a OP b` with both values computed; the mutant has the second.
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
        return a * b;  // no quotient to compare with
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

/// `a OP= b` as `a = a OP b`, which the functions above compute.
template <typename A, typename V>
constexpr A& assigned(A& a, const V value) {
    a = static_cast<A>(value);
    return a;
}

}  // namespace canproof::mutants
