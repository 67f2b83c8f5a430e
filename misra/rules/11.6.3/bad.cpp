// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
enum class Colour { red = 1, green, blue = 2 };  // flagged
