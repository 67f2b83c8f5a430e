// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {};
struct One : virtual Base {};  // flagged
struct Two : Base {};
struct Both : One, Two {};
