// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
char same(const char letter) { return letter; }
