// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/technique_states.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host {

namespace {

Exhibit::State state_in(const Exhibits& exhibits, const std::string& key) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() ? Exhibit::State::absent : found->second.state;
}

std::string title_in(const Exhibits& exhibits, const std::string& key) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() ? key : found->second.title;
}

}  // namespace

std::vector<Technique> techniques_of(const Argument& argument, const Exhibits& exhibits) {
    std::vector<Technique> all = argument.techniques;
    for (auto& technique : all) {
        const auto worst = std::max_element(technique.exhibits.begin(), technique.exhibits.end(),
                                            [&](const std::string& one, const std::string& other) {
                                                return state_in(exhibits, one) < state_in(exhibits, other);
                                            });
        if (worst != technique.exhibits.end() && state_in(exhibits, *worst) != Exhibit::State::holds) {
            const std::string word = word_of(state_in(exhibits, *worst));
            technique.how += fmt::format(" In this pack, this does not count as {}: the evidence ({}) is {}.",
                                         technique.state, title_in(exhibits, *worst), word);
            technique.state = word;
        }
    }
    return all;
}

}  // namespace canproof::host
