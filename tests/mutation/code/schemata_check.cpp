// SPDX-License-Identifier: Apache-2.0
// The mutants that schemata.py finds in example/, each compared with its result computed by hand.
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "host/codegen/alteration.hpp"

namespace canproof {
bool less(unsigned a, unsigned b) noexcept;
bool both(bool a, bool b) noexcept;
bool neither(bool a, bool b) noexcept;
unsigned chosen_by(unsigned a, unsigned b) noexcept;
unsigned lesser(unsigned a, unsigned b) noexcept;
unsigned distance(unsigned a, unsigned b) noexcept;
unsigned sum(unsigned a, unsigned b) noexcept;
unsigned added(unsigned a, unsigned b) noexcept;
unsigned of_a_template(unsigned a) noexcept;
unsigned of_a_constant() noexcept;
unsigned in_order(unsigned a, unsigned b) noexcept;
unsigned set(unsigned a) noexcept;
unsigned apart(unsigned a, unsigned b) noexcept;
unsigned element(unsigned a) noexcept;
unsigned declared(unsigned a) noexcept;
unsigned by_macro(unsigned a) noexcept;
bool of_a_device(unsigned a, unsigned b) noexcept;
}  // namespace canproof

using namespace canproof;

namespace {

using Function = std::function<unsigned(unsigned, unsigned)>;

struct Expected {
    const char* change;
    Function run;
    Function meant;
};

Function of(bool (*function)(unsigned, unsigned) noexcept) {
    return [=](unsigned a, unsigned b) { return function(a, b) ? 1U : 0U; };
}
Function of(bool (*function)(bool, bool) noexcept) {
    return [=](unsigned a, unsigned b) { return function((a & 1U) != 0U, (b & 1U) != 0U) ? 1U : 0U; };
}

const std::vector<Expected> expected{
    {"a < b -> true", of(less), [](unsigned, unsigned) { return 1U; }},
    {"a < b -> false", of(less), [](unsigned, unsigned) { return 0U; }},
    {"a < b -> <=", of(less), [](unsigned a, unsigned b) { return a <= b ? 1U : 0U; }},
    {"a -> variable b", of(less), [](unsigned, unsigned) { return 0U; }},
    {"b -> variable a", of(less), [](unsigned, unsigned) { return 0U; }},
    {"a && b -> ||", of(both), [](unsigned a, unsigned b) { return (a | b) & 1U; }},
    {"a -> true", of(both), [](unsigned, unsigned b) { return b & 1U; }},
    {"a -> false", of(both), [](unsigned, unsigned) { return 0U; }},
    {"a -> variable b", of(both), [](unsigned, unsigned b) { return b & 1U; }},
    {"b -> true", of(both), [](unsigned a, unsigned) { return a & 1U; }},
    {"b -> false", of(both), [](unsigned, unsigned) { return 0U; }},
    {"b -> variable a", of(both), [](unsigned a, unsigned) { return a & 1U; }},
    {"a || b -> &&", of(neither), [](unsigned a, unsigned b) { return ~(a & b) & 1U; }},
    {"a -> true", of(neither), [](unsigned, unsigned) { return 0U; }},
    {"a -> false", of(neither), [](unsigned, unsigned b) { return ~b & 1U; }},
    {"a -> variable b", of(neither), [](unsigned, unsigned b) { return ~b & 1U; }},
    {"b -> true", of(neither), [](unsigned, unsigned) { return 0U; }},
    {"b -> false", of(neither), [](unsigned a, unsigned) { return ~a & 1U; }},
    {"b -> variable a", of(neither), [](unsigned a, unsigned) { return ~a & 1U; }},
    {"a == b -> true", chosen_by, [](unsigned, unsigned) { return 1U; }},
    {"a == b -> false", chosen_by, [](unsigned, unsigned) { return 2U; }},
    {"a -> variable b", chosen_by, [](unsigned, unsigned) { return 1U; }},
    {"b -> variable a", chosen_by, [](unsigned, unsigned) { return 1U; }},
    {"1U -> +1", chosen_by, [](unsigned, unsigned) { return 2U; }},
    {"1U -> -1", chosen_by, [](unsigned a, unsigned b) { return a == b ? 0U : 2U; }},
    {"2U -> +1", chosen_by, [](unsigned a, unsigned b) { return a == b ? 1U : 3U; }},
    {"2U -> -1", chosen_by, [](unsigned, unsigned) { return 1U; }},
    {"a < b -> true", lesser, [](unsigned a, unsigned) { return a; }},
    {"a < b -> false", lesser, [](unsigned, unsigned b) { return b; }},
    {"a -> variable b", lesser, [](unsigned, unsigned b) { return b; }},
    {"b -> variable a", lesser, [](unsigned, unsigned b) { return b; }},
    {"a > b -> true", distance, [](unsigned a, unsigned b) { return a - b; }},
    {"a > b -> false", distance, [](unsigned, unsigned) { return 0U; }},
    {"a -> variable b", distance, [](unsigned, unsigned) { return 0U; }},
    {"b -> variable a", distance, [](unsigned, unsigned) { return 0U; }},
    {"a - b -> +", distance, [](unsigned a, unsigned b) { return a > b ? a + b : 0U; }},
    {"a -> variable b", distance, [](unsigned, unsigned) { return 0U; }},
    {"b -> variable a", distance, [](unsigned, unsigned) { return 0U; }},
    {"0U -> +1", distance, [](unsigned a, unsigned b) { return a > b ? a - b : 1U; }},
    {"a + b -> -", sum, [](unsigned a, unsigned b) { return a - b; }},
    {"a -> variable b", sum, [](unsigned, unsigned b) { return b + b; }},
    {"b -> variable a", sum, [](unsigned a, unsigned) { return a + a; }},
    {"a -> variable b", added, [](unsigned, unsigned b) { return b + b; }},
    {"total += b -> dropped", added, [](unsigned a, unsigned) { return a; }},
    {"total += b -> -=", added, [](unsigned a, unsigned b) { return a - b; }},
    {"b -> variable total", added, [](unsigned a, unsigned) { return a + a; }},
    {"total -> variable a", added, [](unsigned a, unsigned) { return a; }},
    {"a * 2U -> /", [](unsigned, unsigned) { return of_a_constant(); }, [](unsigned, unsigned) { return 8U; }},
    {"2U -> +1", [](unsigned, unsigned) { return of_a_constant(); }, [](unsigned, unsigned) { return 8U; }},
    {"2U -> -1", [](unsigned, unsigned) { return of_a_constant(); }, [](unsigned, unsigned) { return 8U; }},
    {"a + N -> -", [](unsigned a, unsigned) { return of_a_template(a); }, [](unsigned a, unsigned) { return a - 4U; }},
    {"first = first * 10U + digit -> dropped", in_order, [](unsigned, unsigned) { return 0U; }},
    {"first * 10U + digit -> -", in_order, [](unsigned a, unsigned b) { return (0U - a) * 10U - b; }},
    {"first * 10U -> /", in_order, [](unsigned a, unsigned b) { return (a / 10U) + b; }},
    {"first -> variable second", in_order, [](unsigned, unsigned b) { return b; }},
    {"10U -> +1", in_order, [](unsigned a, unsigned b) { return a * 11U + b; }},
    {"10U -> -1", in_order, [](unsigned a, unsigned b) { return a * 9U + b; }},
    {"log.shift(a) -> swapped with log.shift(b)", in_order, [](unsigned a, unsigned b) { return b * 10U + a; }},
    {"log.shift(a) -> deleted", in_order, [](unsigned, unsigned b) { return b; }},
    {"a -> variable b", in_order, [](unsigned, unsigned b) { return b * 11U; }},
    {"log.shift(b) -> deleted", in_order, [](unsigned a, unsigned) { return a; }},
    {"b -> variable a", in_order, [](unsigned a, unsigned) { return a * 11U; }},
    {"log.first -> variable log.second", in_order, [](unsigned, unsigned) { return 0U; }},
    {"7U -> +1", [](unsigned a, unsigned) { return set(a); }, [](unsigned a, unsigned) { return a; }},
    {"7U -> -1", [](unsigned a, unsigned) { return set(a); }, [](unsigned a, unsigned) { return a; }},
    {"kept = a -> dropped", [](unsigned a, unsigned) { return set(a); }, [](unsigned, unsigned) { return 7U; }},
    {"a -> variable kept", [](unsigned a, unsigned) { return set(a); }, [](unsigned, unsigned) { return 7U; }},
    {"kept -> variable a", [](unsigned a, unsigned) { return set(a); }, [](unsigned a, unsigned) { return a; }},
    {"logs.kept.shift(a) -> swapped with logs.kept.shift(b)", apart,
     [](unsigned a, unsigned b) { return b * 10U + a; }},
    {"logs.kept.shift(a) -> deleted", apart, [](unsigned, unsigned b) { return b; }},
    {"a -> variable b", apart, [](unsigned, unsigned b) { return b * 11U; }},
    {"logs.kept.shift(b) -> deleted", apart, [](unsigned a, unsigned) { return a; }},
    {"b -> variable a", apart, [](unsigned a, unsigned) { return a * 11U; }},
    // This call is not swapped with any other, because it uses another object.
    {"logs.other.shift(a) -> deleted", apart, [](unsigned a, unsigned b) { return a * 10U + b; }},
    {"a -> variable b", apart, [](unsigned a, unsigned b) { return a * 10U + b; }},
    {"logs.kept.first -> variable logs.kept.second", apart, [](unsigned, unsigned) { return 0U; }},
    {"list[a] -> [0]", [](unsigned a, unsigned) { return element(a); }, [](unsigned, unsigned) { return 10U; }},
    // The declaration of a variable in a condition has no mutants; the rest of the statement has.
    {"kept -> variable a", [](unsigned a, unsigned) { return declared(a); },
     [](unsigned a, unsigned) { return a != 0U ? a : 9U; }},
    {"9U -> +1", [](unsigned a, unsigned) { return declared(a); },
     [](unsigned a, unsigned) { return a != 0U ? a : 10U; }},
    {"9U -> -1", [](unsigned a, unsigned) { return declared(a); },
     [](unsigned a, unsigned) { return a != 0U ? a : 8U; }},
    {"a != b -> true", of(of_a_device), [](unsigned, unsigned) { return 1U; }},
    {"a != b -> false", of(of_a_device), [](unsigned, unsigned) { return 0U; }},
    {"a -> variable b", of(of_a_device), [](unsigned, unsigned) { return 0U; }},
    {"b -> variable a", of(of_a_device), [](unsigned, unsigned) { return 0U; }},
};

unsigned faults(std::size_t number, const host::Alteration* mutant, const Function& run, const Function& meant) {
    mutants::chosen = 0U;
    if (mutant != nullptr) {
        std::memcpy(mutant->address, &mutant->bits, mutant->size);
    }
    unsigned count = 0;
    for (unsigned a = 0; a < 4; ++a) {
        for (unsigned b = 0; b < 4; ++b) {
            if (run(a, b) != meant(a, b)) {
                std::printf("mutant %zu of %u and %u: %u, not %u\n", number, a, b, run(a, b), meant(a, b));
                ++count;
            }
        }
    }
    return count;
}

}  // namespace

int main() {
    const auto all = host::generated_alterations();
    unsigned count = all.count == expected.size() ? 0U : 1U;
    for (std::size_t i = 0; i < all.count && i < expected.size(); ++i) {
        if (std::strcmp(all.first[i].change, expected[i].change) != 0) {
            std::printf("mutant %zu is `%s`, not `%s`\n", i, all.first[i].change, expected[i].change);
            ++count;
        }
        count += faults(i, &all.first[i], expected[i].run, expected[i].meant);
    }
    count += faults(0, nullptr, of(less), [](unsigned a, unsigned b) { return a < b ? 1U : 0U; });
    count += faults(0, nullptr, of(both), [](unsigned a, unsigned b) { return a & b & 1U; });
    count += faults(0, nullptr, of(neither), [](unsigned a, unsigned b) { return ~(a | b) & 1U; });
    count += faults(0, nullptr, sum, [](unsigned a, unsigned b) { return a + b; });
    count += faults(0, nullptr, in_order, [](unsigned a, unsigned b) { return a * 10U + b; });
    count += faults(
        0, nullptr, [](unsigned a, unsigned) { return set(a); }, [](unsigned a, unsigned) { return a; });
    count += faults(
        0, nullptr, [](unsigned a, unsigned) { return element(a); }, [](unsigned a, unsigned) { return 10U + a; });
    // A choice that a macro makes has no mutants: its text is not in the file.
    count += faults(
        0, nullptr, [](unsigned a, unsigned) { return by_macro(a); },
        [](unsigned a, unsigned) { return a != 0U ? 10U : 11U; });
    std::printf("%zu mutants, %u faults\n", all.count, count);
    return count == 0U ? 0 : 1;
}
