// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool some(const int count) { return count != 0; }
bool set(const int* const place) { return place != nullptr; }
