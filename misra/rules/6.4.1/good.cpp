// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int outer(const int value) {
    int sum{value};
    for (int i = 0; i < 3; ++i) {
        sum += i;
    }
    return sum;
}
