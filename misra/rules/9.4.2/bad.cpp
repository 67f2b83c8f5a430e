// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int choose(const int value) {
    int result{0};
    switch (value) {  // flagged
        case 1:
            result = 1;
            break;
        case 2:
            result = 2;
            break;
    }
    switch (value) {
        case 1:
            result = 1;
        case 2:  // flagged
            result = 2;
            break;
        default:
            break;
    }
    return result;
}
