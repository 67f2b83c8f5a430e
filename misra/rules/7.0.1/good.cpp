// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int as_number(const bool set) { return set ? 1 : 0; }
bool same(const bool one, const bool other) { return one == other; }
