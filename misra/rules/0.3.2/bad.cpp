// SPDX-License-Identifier: Apache-2.0
// The checkers must report each line marked `flagged` for a review by a person.
#include <cmath>
#include <optional>
double root(const double value) {
    return std::sqrt(value);  // flagged
}
int kept(const std::optional<int>& value) {
    return *value;  // flagged
}
