// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int enter(const int value) { return ((value > 3) || (value < 0)) ? 1 : 0; }
