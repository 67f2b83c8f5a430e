// SPDX-License-Identifier: Apache-2.0
// Links a test to a rule of this project, such as "no heap", that is in no manual.
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// Records that the running test shows the project rule `rule`, for example that nothing allocates from the heap.
inline void shows_rule(const char* rule) {
    testing::Test::RecordProperty("rule", rule);
}

}  // namespace canproof::test
