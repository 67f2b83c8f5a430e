// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
void shift(char* const text) {
    for (int i = 4; i > 0; --i) {
        text[i] = text[i - 1];
    }
}
