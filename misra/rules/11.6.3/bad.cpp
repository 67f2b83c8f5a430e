// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
enum class Colour { red = 1, green, blue = 2 };  // flagged
