// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int choose(const int value) {
    int result{0};
    switch (value) {
        case 1:
            result = 1;
            break;
        case 2:
        case 3:
            result = 2;
            break;
        default:
            break;
    }
    return result;
}
