// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int call(int one, int other);
int both(const int one, const int other) { return call(one, other); }
