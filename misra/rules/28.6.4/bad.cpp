// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <algorithm>
#include <vector>
void drop(std::vector<int>& row) {
    std::remove(row.begin(), row.end(), 3);  // flagged
}
void clear(std::vector<int>& row) {
    row.empty();  // flagged
}
