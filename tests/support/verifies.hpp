// SPDX-License-Identifier: Apache-2.0
// Links a test to the requirements that it verifies. The link is written to the result of the test when the test runs.
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// Records that the running test shows these requirements. A retired or misspelt requirement does not compile. `kind`
/// is "test", "property" or "fuzz".
template <typename... Requirements>
void verifies(const char* kind = "test") {
    (testing::Test::RecordProperty(Requirements::id, kind), ...);
}

}  // namespace canproof::test
