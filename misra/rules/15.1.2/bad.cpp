// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    Base();
};
struct Derived : Base {
    explicit Derived(int value) : kept{value} {}  // flagged
    int kept;
};
