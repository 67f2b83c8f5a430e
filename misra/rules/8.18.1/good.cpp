// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
void shift(char* const text) {
    for (int i = 4; i > 0; --i) {
        text[i] = text[i - 1];
    }
}
