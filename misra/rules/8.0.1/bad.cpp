// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int sum(const int one, const int two, const int three) {
    return one + two * three;  // flagged
}
bool either(const bool one, const bool two, const bool three) {
    return one || two && three;  // flagged
}
