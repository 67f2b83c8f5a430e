// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(double value);  // flagged
};
