// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Base {
    Base();
};
struct Derived : Base {
    explicit Derived(int value) : Base{}, kept{value} {}
    int kept;
};
