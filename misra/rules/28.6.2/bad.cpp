// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <utility>
template <typename T>
void take(T value);
template <typename T>
void give(T&& value) {
    take(std::move(value));  // flagged
}
