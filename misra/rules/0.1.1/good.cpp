// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int kept(const int value) {
    int copy = value;
    copy += 4;
    return copy;
}
