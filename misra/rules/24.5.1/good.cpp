// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
bool digit(const char letter) { return (letter >= '0') && (letter <= '9'); }
