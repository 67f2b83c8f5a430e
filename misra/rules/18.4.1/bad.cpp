// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Row {
    Row(Row&& other);         // flagged
    ~Row() noexcept(false);   // flagged
};
void swap(Row& one, Row& other);  // flagged
