// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <string>
#include <utility>
void take(std::string text);
char first(std::string text) {
    take(std::move(text));
    return text.front();  // flagged
}
