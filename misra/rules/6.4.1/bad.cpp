// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int outer(const int value) {
    int sum{value};
    for (int i = 0; i < 3; ++i) {
        const int value{i};  // flagged
        sum += value;
    }
    return sum;
}
