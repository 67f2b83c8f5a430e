// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <vector>
bool first(const std::vector<bool>& row) {  // flagged
    return row.front();
}
