// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <vector>
int* make() {
    return new int(3);  // flagged
}
int count() {
    const std::vector<int> row{1, 2};  // flagged
    return row.front();
}
