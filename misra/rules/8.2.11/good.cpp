// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
template <typename... Values>
int count(const Values... values) {
    return static_cast<int>(sizeof...(values));
}
int use() { return count(1, 2); }
