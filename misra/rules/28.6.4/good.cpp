// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <algorithm>
#include <vector>
void drop(std::vector<int>& row) { row.erase(std::remove(row.begin(), row.end(), 3), row.end()); }
