// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int as_number(const bool set) {
    return set;  // flagged
}
int as_number_too(const bool set) {
    return static_cast<int>(set);  // flagged
}
