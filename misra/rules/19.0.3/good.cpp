// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
// A comment may be above the includes.
#include <cstddef>
std::size_t size();
