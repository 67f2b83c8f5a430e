// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int whole(const double value) { return static_cast<int>(value); }
long wide(const int value) { return long{value}; }
