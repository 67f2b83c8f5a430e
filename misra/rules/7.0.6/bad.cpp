// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
short small(const int value) {
    return value;  // flagged
}
int whole(const double value) {
    return value;  // flagged
}
float single(const double value) {
    return value;  // flagged
}
unsigned plain(const int value) {
    return value;  // flagged
}
