// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    virtual int read(int value = 3);  // flagged
};
struct Derived : Base {
    int read(int value = 4) override;  // flagged
};
