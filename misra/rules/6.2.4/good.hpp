// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
inline int twice(const int value) { return 2 * value; }
inline constexpr int step{1};
