// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <utility>
template <typename T>
void take(T value);
template <typename T>
void give(T&& value) {
    take(std::move(value));  // flagged
}
