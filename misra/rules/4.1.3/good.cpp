// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int shares(const int value, const int by) { return (by == 0) ? 0 : (value / by); }
int follow(const int* const place) { return (place == nullptr) ? 0 : *place; }
