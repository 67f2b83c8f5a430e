// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <string>
#include <utility>
void take(std::string text);
void give(const std::string& text) {
    take(std::move(text));  // flagged
}
