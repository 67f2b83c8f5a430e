// SPDX-License-Identifier: Apache-2.0
// Each marked line must be reported for a review.
constexpr unsigned few = 3U;
unsigned below() {
    return few - 4U;  // flagged
}
