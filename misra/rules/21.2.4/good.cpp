// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <cstddef>
std::size_t place() { return sizeof(int); }
