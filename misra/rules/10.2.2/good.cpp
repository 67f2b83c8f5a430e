// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
enum class Colour : unsigned char { red };
