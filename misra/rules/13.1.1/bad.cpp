// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {};
struct Derived : virtual Base {};  // flagged
