// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <string>
#include <utility>
void take(std::string text);
char first(std::string text) {
    take(std::move(text));
    return text.front();  // flagged
}
