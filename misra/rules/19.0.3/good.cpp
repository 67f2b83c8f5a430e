// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
// A comment may come first.
#include <cstddef>
std::size_t size();
