// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int sum(const int one, const int two, const int three) { return one + (two * three); }
