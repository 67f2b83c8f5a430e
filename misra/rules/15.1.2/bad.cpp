// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    Base();
};
struct Derived : Base {
    explicit Derived(int value) : kept{value} {}  // flagged
    int kept;
};
