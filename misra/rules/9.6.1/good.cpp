// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int leave(const int value) { return (value > 3) ? 3 : value; }
