// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#include <array>
std::array<int, 3> row;
