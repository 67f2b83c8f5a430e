// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int fail(const int value) noexcept { return (value > 3) ? 3 : value; }
