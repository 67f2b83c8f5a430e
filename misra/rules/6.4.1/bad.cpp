// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int outer(const int value) {
    int sum{value};
    for (int i = 0; i < 3; ++i) {
        const int value{i};  // flagged
        sum += value;
    }
    return sum;
}
