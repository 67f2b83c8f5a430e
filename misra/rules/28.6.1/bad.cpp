// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <string>
#include <utility>
void take(std::string text);
void give(const std::string& text) {
    take(std::move(text));  // flagged
}
