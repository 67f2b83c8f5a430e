// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <cstddef>
std::size_t place() { return sizeof(int); }
