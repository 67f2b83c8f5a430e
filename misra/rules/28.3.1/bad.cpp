// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <algorithm>
#include <array>
bool third(const std::array<int, 4>& row) {
    int seen{0};
    return std::any_of(row.begin(), row.end(), [seen](const int) mutable {  // flagged
        ++seen;
        return seen == 3;
    });
}
