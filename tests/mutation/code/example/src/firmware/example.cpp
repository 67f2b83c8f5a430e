// SPDX-License-Identifier: Apache-2.0
// The code that schemata.py mutates for schemata_check.cpp, with one construct per function.
#include <type_traits>

namespace canproof {

bool less(const unsigned a, const unsigned b) noexcept {
    return a < b;
}
bool both(const bool a, const bool b) noexcept {
    return a && b;
}
bool neither(const bool a, const bool b) noexcept {
    return !(a || b);
}
unsigned chosen_by(const unsigned a, const unsigned b) noexcept {
    return (a == b) ? 1U : 2U;
}
unsigned lesser(const unsigned a, const unsigned b) noexcept {
    return (a < b) ? a : b;
}
unsigned distance(const unsigned a, const unsigned b) noexcept {
    return (a > b) ? (a - b) : 0U;
}
unsigned sum(const unsigned a, const unsigned b) noexcept {
    return a + b;
}
unsigned added(const unsigned a, const unsigned b) noexcept {
    unsigned total = a;
    total += b;
    return total;
}
constexpr unsigned twice(const unsigned a) noexcept {
    return a * 2U;
}
static_assert(twice(4U) == 8U);
template <unsigned N>
unsigned plus_constant(const unsigned a) noexcept {
    return a + N;
}
unsigned of_a_template(const unsigned a) noexcept {
    return plus_constant<2U * 2U>(a);
}
template <unsigned N>
unsigned of_a_type(const unsigned a) noexcept {
    const std::conditional_t<(N == 4U), unsigned char, unsigned> held = a;
    return held;
}
unsigned of_a_constant() noexcept {
    constexpr unsigned eight = twice(4U);
    return eight;
}
struct Log {
    unsigned first{0U};
    unsigned second{0U};
    void shift(const unsigned digit) noexcept { first = first * 10U + digit; }
};
unsigned in_order(const unsigned a, const unsigned b) noexcept {
    Log log;
    log.shift(a);
    log.shift(b);
    return log.first;
}
unsigned set(const unsigned a) noexcept {
    unsigned kept = 7U;
    kept = a;
    return kept;
}
struct Logs {
    Log kept{};
    Log other{};
};
unsigned apart(const unsigned a, const unsigned b) noexcept {
    Logs logs;
    logs.kept.shift(a);
    logs.kept.shift(b);
    logs.other.shift(a);
    return logs.kept.first;
}
constexpr unsigned list[4] = {10U, 11U, 12U, 13U};
unsigned element(const unsigned a) noexcept {
    return list[a];
}
unsigned declared(const unsigned a) noexcept {
    if (const unsigned kept = a) {
        return kept;
    }
    return 9U;
}
#define FIRST_OF(a) ((a) != 0U ? &list[0] : &list[1])
unsigned by_macro(const unsigned a) noexcept {
    const unsigned* const first = FIRST_OF(a);
    return *first;
}

}  // namespace canproof
