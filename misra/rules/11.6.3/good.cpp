// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
enum class Colour { red = 1, green = 2, blue = 3 };
