// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
bool never(const unsigned value) {
    return value < 0U;  // flagged
}
bool always(const unsigned value) {
    return value == value;  // flagged
}
