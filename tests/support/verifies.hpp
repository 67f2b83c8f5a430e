// SPDX-License-Identifier: Apache-2.0
// Links a test to the requirements that it verifies. When the test runs, its result file receives the link.
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// Records that the running test shows these requirements. A misspelt requirement, or one that was withdrawn, gives a
/// compile error. `kind` is "test", "property" or "fuzz".
template <typename... Requirements>
void verifies(const char* kind = "test") {
    (testing::Test::RecordProperty(Requirements::id, kind), ...);
}

}  // namespace canproof::test
