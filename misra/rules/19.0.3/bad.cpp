// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int now();
#include <cstddef>  // flagged
std::size_t size();
