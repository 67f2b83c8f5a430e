// SPDX-License-Identifier: Apache-2.0
// Links a test to a rule that is in no manual but that this project has set for itself, such as "no heap".
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// Records that the running test shows that the project rule `rule` is kept, for example that nothing allocates from
/// the heap.
inline void shows_rule(const char* rule) {
    testing::Test::RecordProperty("rule", rule);
}

}  // namespace canproof::test
