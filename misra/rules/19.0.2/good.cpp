// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
constexpr int twice(const int value) { return value + value; }
int now() { return twice(2); }
