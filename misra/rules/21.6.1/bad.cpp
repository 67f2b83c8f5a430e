// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <vector>
int* make() {
    return new int(3);  // flagged
}
int count() {
    const std::vector<int> row{1, 2};  // flagged
    return row.front();
}
