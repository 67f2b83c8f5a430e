// SPDX-License-Identifier: Apache-2.0
// The common part of the tests of the compiler's library. The compiler can compute a result by itself, and then a test
// of the library tests nothing: hidden() prevents this.
#pragma once

#include <cmath>
#include <cstring>

#include "tests/support/shows_rule.hpp"

namespace canproof::test {

/// Returns `value` in a way that the compiler cannot follow. An operation on the result therefore happens when the test
/// runs, not when it is compiled.
template <typename T>
T hidden(const T value) {
    volatile T kept = value;
    return kept;
}

/// Returns whether two floats or doubles have the same bits, or are both NaN.
template <typename T>
bool same(const T one, const T other) {
    return (std::isnan(one) && std::isnan(other)) || (std::memcmp(&one, &other, sizeof one) == 0);
}

/// Records the rule that all these tests show.
inline void shows_library_rule() {
    shows_rule("the compiler's library computes what C++ and IEEE 754 define");
}

}  // namespace canproof::test
