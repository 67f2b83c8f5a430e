// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <string_view>
unsigned long length(const std::string_view text) { return text.size(); }
