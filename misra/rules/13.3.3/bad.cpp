// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int area(int width, int height);  // flagged
int area(int height, int width) { return width * height; }
