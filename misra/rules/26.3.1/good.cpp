// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <bitset>
bool first(const std::bitset<8>& row) { return row[0]; }
