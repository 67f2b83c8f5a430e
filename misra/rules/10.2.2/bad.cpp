// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
enum Colour : unsigned char { red };  // flagged
