// SPDX-License-Identifier: Apache-2.0
#include "host/prove/state.hpp"

#include <algorithm>

namespace canproof::host::prove {

namespace {

bool are_opposite(const Term& a, const Term& b) {
    return (a.is_not() && same(a.arg(0), b)) || (b.is_not() && same(b.arg(0), a));
}

}  // namespace

Meeting meet(z3::context& context, const std::vector<Term>& first, const std::vector<Term>& second) {
    const std::size_t shorter = std::min(first.size(), second.size());
    std::size_t common = 0;
    while (common < shorter && same(first[common], second[common])) {
        ++common;
    }
    const auto rest = [&](const std::vector<Term>& path, std::size_t from) {
        return all_of(context, {path.begin() + static_cast<std::ptrdiff_t>(from), path.end()});
    };
    const std::vector<Term> shared{first.begin(), first.begin() + static_cast<std::ptrdiff_t>(common)};
    if (common < shorter && are_opposite(first[common], second[common])) {
        // One branch has separated the two paths. In the merged path, the further conditions of each path must hold on
        // its side of the branch.
        Meeting meeting{first[common], shared, {}};
        for (const Term& one :
             {!first[common] || rest(first, common + 1), !second[common] || rest(second, common + 1)}) {
            const Term demanded = one.simplify();
            if (!is_true(demanded)) {
                meeting.path.push_back(demanded);
            }
        }
        return meeting;
    }
    Meeting meeting{rest(first, common), shared, {}};
    const Term either = (meeting.first_holds || rest(second, common)).simplify();
    if (!is_true(either)) {
        meeting.either = either;
    }
    return meeting;
}

Term merge(Solver& solver, const Objects& objects, State& first, const State& second) {
    constexpr unsigned milliseconds = 100;
    const Meeting meeting = meet(solver.context(), first.path, second.path);
    first.path = meeting.path;
    if (meeting.either && solver.satisfiable(first.path, !*meeting.either, milliseconds) != Answer::no) {
        first.path.push_back(*meeting.either);
    }
    first.memory.merge(objects, meeting.first_holds, second.memory);
    first.paths += second.paths;
    return meeting.first_holds;
}

}  // namespace canproof::host::prove
