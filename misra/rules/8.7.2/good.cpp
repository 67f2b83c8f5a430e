// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
const int* before(const int* const one) { return one - 1; }
