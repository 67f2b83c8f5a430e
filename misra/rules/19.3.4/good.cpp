// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
constexpr int twice(const int value) { return value * 2; }
int now() { return twice(1 + 2); }
