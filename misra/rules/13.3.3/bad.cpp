// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int area(int width, int height);  // flagged
int area(int height, int width) { return width * height; }
