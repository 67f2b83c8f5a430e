// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
static_assert(sizeof(int) == 4U);
void check();
