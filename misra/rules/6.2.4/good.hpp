// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
inline int twice(const int value) { return 2 * value; }
inline constexpr int step{1};
