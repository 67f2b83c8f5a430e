// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Row {
    int first;
    explicit Row(int value) noexcept : first{value} {}
};
