// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool same(const int* const one, const int* const other) { return one == other; }
