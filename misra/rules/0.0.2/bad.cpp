// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
bool never(const unsigned value) {
    return value < 0U;  // flagged
}
bool always(const unsigned value) {
    return value == value;  // flagged
}
