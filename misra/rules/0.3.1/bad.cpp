// SPDX-License-Identifier: Apache-2.0
// Each marked line must be reported for a review.
float mean(const float one, const float other) {
    return (one + other) / 2.0F;  // flagged
}
int whole(const double value) {
    return static_cast<int>(value);  // flagged
}
