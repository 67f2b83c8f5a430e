// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int one(const int value, const int) { return value; }
