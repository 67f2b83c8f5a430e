// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
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
