// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
enum Colour : unsigned char { red };  // flagged
