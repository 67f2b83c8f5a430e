// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
static_assert(sizeof(int) == 4U);
void check();
