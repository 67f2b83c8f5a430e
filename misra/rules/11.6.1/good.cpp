// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int early(const bool set) {
    const int value{set ? 1 : 2};
    return value;
}
