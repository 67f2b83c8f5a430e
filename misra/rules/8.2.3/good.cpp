// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
const int& closed(int& value) { return static_cast<const int&>(value); }
