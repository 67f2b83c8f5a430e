// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
enum Colour { red, blue };  // flagged
int next(const Colour colour) { return colour + 1; }
