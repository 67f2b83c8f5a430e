// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Row {
    Row(Row&& other) noexcept;
    ~Row();
};
void swap(Row& one, Row& other) noexcept;
