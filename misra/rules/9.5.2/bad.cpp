// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <array>
struct Row {
    std::array<int, 3> cells() const;
};
Row row();
int sum() {
    int total{0};
    for (const int cell : row().cells()) {  // flagged
        total += cell;
    }
    return total;
}
