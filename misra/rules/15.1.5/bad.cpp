// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <initializer_list>
struct Row {
    Row(std::initializer_list<int> cells);  // flagged
    explicit Row(int size);
};
