// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
short small(const int value) { return static_cast<short>(value); }
long wide(const int value) { return value; }
