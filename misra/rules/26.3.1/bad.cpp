// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <vector>
bool first(const std::vector<bool>& row) {  // flagged
    return row.front();
}
