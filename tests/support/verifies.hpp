// Links from tests to the register: recorded with the verdict when the test runs.
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// Says that the running test shows these requirements; one that is retired or misspelt does not compile. `kind` is
/// how: "test", "property" or "fuzz".
template <typename... Requirements>
void verifies(const char* kind = "test") {
    (testing::Test::RecordProperty(Requirements::id, kind), ...);
}

}  // namespace canproof::test
