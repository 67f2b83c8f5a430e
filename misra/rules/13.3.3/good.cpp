// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int area(int width, int height);
int area(const int width, const int height) { return width * height; }
