// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int chain(int& one, int& other) {
    one = other = 3;  // flagged
    if ((one = other) != 0) {  // flagged
        return 1;
    }
    return 0;
}
