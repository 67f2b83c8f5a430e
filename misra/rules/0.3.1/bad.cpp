// SPDX-License-Identifier: Apache-2.0
// The checkers must report each line marked `flagged` for a review by a person.
float mean(const float one, const float other) {
    return (one + other) / 2.0F;  // flagged
}
int whole(const double value) {
    return static_cast<int>(value);  // flagged
}
