// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
constexpr int twice(const int value) { return value + value; }
int now() { return twice(2); }
