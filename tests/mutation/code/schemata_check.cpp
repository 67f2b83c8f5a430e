// The mutants that schemata.py finds in example/, each against what it should compute, by hand.
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
    {"a && b -> ||", of(both), [](unsigned a, unsigned b) { return (a | b) & 1U; }},
    {"a -> true", of(both), [](unsigned, unsigned b) { return b & 1U; }},
    {"a -> false", of(both), [](unsigned, unsigned) { return 0U; }},
    {"b -> true", of(both), [](unsigned a, unsigned) { return a & 1U; }},
    {"b -> false", of(both), [](unsigned, unsigned) { return 0U; }},
    {"a || b -> &&", of(neither), [](unsigned a, unsigned b) { return ~(a & b) & 1U; }},
    {"a -> true", of(neither), [](unsigned, unsigned) { return 0U; }},
    {"a -> false", of(neither), [](unsigned, unsigned b) { return ~b & 1U; }},
    {"b -> true", of(neither), [](unsigned, unsigned) { return 0U; }},
    {"b -> false", of(neither), [](unsigned a, unsigned) { return ~a & 1U; }},
    {"a == b -> true", chosen_by, [](unsigned, unsigned) { return 1U; }},
    {"a == b -> false", chosen_by, [](unsigned, unsigned) { return 2U; }},
    {"a < b -> true", lesser, [](unsigned a, unsigned) { return a; }},
    {"a < b -> false", lesser, [](unsigned, unsigned b) { return b; }},
    {"a > b -> true", distance, [](unsigned a, unsigned b) { return a - b; }},
    {"a > b -> false", distance, [](unsigned, unsigned) { return 0U; }},
    {"a - b -> +", distance, [](unsigned a, unsigned b) { return a > b ? a + b : 0U; }},
    {"a + b -> -", sum, [](unsigned a, unsigned b) { return a - b; }},
    {"total += b -> -=", added, [](unsigned a, unsigned b) { return a - b; }},
    {"a * 2U -> /", [](unsigned, unsigned) { return of_a_constant(); }, [](unsigned, unsigned) { return 8U; }},
    {"a + N -> -", [](unsigned a, unsigned) { return of_a_template(a); }, [](unsigned a, unsigned) { return a - 4U; }},
    {"a != b -> true", of(of_a_device), [](unsigned, unsigned) { return 1U; }},
    {"a != b -> false", of(of_a_device), [](unsigned, unsigned) { return 0U; }},
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
    std::printf("%zu mutants, %u faults\n", all.count, count);
    return count == 0U ? 0 : 1;
}
