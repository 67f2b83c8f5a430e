// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#define HEADER <cstddef>
#include HEADER  // flagged
std::size_t now();
