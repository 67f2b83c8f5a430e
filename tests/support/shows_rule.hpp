// For tests of what no manual demands.
#pragma once

#include <gtest/gtest.h>

namespace canproof::test {

/// The running test shows a rule of the house, as that nothing is taken from the heap: `rule` says which.
inline void shows_rule(const char* rule) {
    testing::Test::RecordProperty("rule", rule);
}

}  // namespace canproof::test
