// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Base {
    virtual int read();
};
struct Derived : Base {
    int read() override;
};
