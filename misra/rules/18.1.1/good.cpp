// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool fail(const int& value) { return value > 3; }
