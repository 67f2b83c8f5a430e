// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    Base();
};
struct Derived : Base {
    explicit Derived(int value) : Base{}, kept{value} {}
    int kept;
};
