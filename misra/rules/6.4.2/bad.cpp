// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(double value);  // flagged
};
