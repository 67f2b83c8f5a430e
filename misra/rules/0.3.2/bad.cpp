// SPDX-License-Identifier: Apache-2.0
// Each marked line must be reported for a review.
#include <cmath>
#include <optional>
double root(const double value) {
    return std::sqrt(value);  // flagged
}
int kept(const std::optional<int>& value) {
    return *value;  // flagged
}
