// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {};
struct One : virtual Base {};  // flagged
struct Two : Base {};
struct Both : One, Two {};
