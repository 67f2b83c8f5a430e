// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    virtual ~Base();
};
struct Derived : virtual Base {  // flagged
};
