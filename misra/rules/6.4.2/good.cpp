// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(int value) override;
};
