// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    virtual ~Base();
};
struct Derived : virtual Base {  // flagged
};
