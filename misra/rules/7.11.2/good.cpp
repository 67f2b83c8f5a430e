// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <array>
int total(const std::array<int, 3>& row);
int use() {
    const std::array<int, 3> row{1, 2, 3};
    return total(row);
}
