// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
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
