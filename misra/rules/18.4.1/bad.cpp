// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Row {
    Row(Row&& other);         // flagged
    ~Row() noexcept(false);   // flagged
};
void swap(Row& one, Row& other);  // flagged
