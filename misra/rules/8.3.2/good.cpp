// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int same(const int value) { return 0 + value; }
