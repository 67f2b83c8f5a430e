// SPDX-License-Identifier: Apache-2.0
#include "host/prove/state.hpp"

#include <algorithm>

namespace canproof::host::prove {

Meeting meet(z3::context& context, const std::vector<Term>& first, const std::vector<Term>& second) {
    const std::size_t shorter = std::min(first.size(), second.size());
    std::size_t common = 0;
    while (common < shorter && same(first[common], second[common])) {
        ++common;
    }
    const auto rest = [&](const std::vector<Term>& path) {
        return all_of(context, {path.begin() + static_cast<std::ptrdiff_t>(common), path.end()});
    };
    Meeting meeting{rest(first), {first.begin(), first.begin() + static_cast<std::ptrdiff_t>(common)}};
    const Term either = (meeting.first_holds || rest(second)).simplify();
    if (!is_true(either)) {
        meeting.path.push_back(either);
    }
    return meeting;
}

Term merge(z3::context& context, const Objects& objects, State& first, const State& second) {
    const Meeting meeting = meet(context, first.path, second.path);
    first.path = meeting.path;
    first.memory.merge(objects, meeting.first_holds, second.memory);
    first.paths += second.paths;
    return meeting.first_holds;
}

}  // namespace canproof::host::prove
