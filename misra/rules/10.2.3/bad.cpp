// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
enum Colour { red, blue };  // flagged
int next(const Colour colour) { return colour + 1; }
