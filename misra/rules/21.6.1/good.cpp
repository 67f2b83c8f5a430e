// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <array>
int count() {
    const std::array<int, 2> row{1, 2};
    return row.front();
}
