// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <algorithm>
#include <vector>
void drop(std::vector<int>& row) { row.erase(std::remove(row.begin(), row.end(), 3), row.end()); }
