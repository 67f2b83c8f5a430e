// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <string>
#include <utility>
void take(std::string text);
void give(std::string text) { take(std::move(text)); }
