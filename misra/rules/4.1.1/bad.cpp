// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Point {
    int x;
    int y;
};
Point corner() {
    return Point{.x = 1, .y = 2};  // flagged
}
int shorter(const int value) {
    return value ?: 3;  // flagged
}
