// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <algorithm>
#include <array>
bool big(const std::array<int, 4>& row) {
    return std::any_of(row.begin(), row.end(), [](const int cell) { return cell > 3; });
}
