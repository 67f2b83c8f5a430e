// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    virtual int read();
};
struct Derived : Base {
    int read();  // flagged
};
struct Other : Base {
    virtual int read() override;  // flagged
};
