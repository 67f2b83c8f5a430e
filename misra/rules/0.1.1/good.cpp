// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int kept(const int value) {
    int copy = value;
    copy += 4;
    return copy;
}
