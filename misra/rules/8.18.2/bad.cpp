// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int chain(int& one, int& other) {
    one = other = 3;  // flagged
    if ((one = other) != 0) {  // flagged
        return 1;
    }
    return 0;
}
