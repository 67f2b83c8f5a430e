// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <utility>
template <typename T>
void take(T value);
template <typename T>
void give(T&& value) {
    take(std::forward<T>(value));
}
