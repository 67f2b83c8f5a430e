// SPDX-License-Identifier: Apache-2.0
// Names the requirements that a fuzz target verifies, as C++ types, so that an unknown requirement does not compile.
// The replay of the target's corpus writes these names into its result.
#pragma once

#include <string>
#include <vector>

namespace canproof::fuzz {

std::vector<std::string> claims();

}  // namespace canproof::fuzz

#define CANPROOF_FUZZ_CLAIMS(...)       \
    namespace canproof::fuzz {          \
    template <typename... Requirements> \
    std::vector<std::string> ids() {    \
        return {Requirements::id...};   \
    }                                   \
    std::vector<std::string> claims() { \
        return ids<__VA_ARGS__>();      \
    }                                   \
    }
