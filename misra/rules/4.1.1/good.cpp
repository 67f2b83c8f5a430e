// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Point {
    int x;
    int y;
};
Point corner() { return Point{1, 2}; }
