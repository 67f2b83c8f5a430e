// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool sometimes(const unsigned value) { return value < 3U; }
