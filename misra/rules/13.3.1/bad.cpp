// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    virtual int read();
};
struct Derived : Base {
    int read();  // flagged
};
struct Other : Base {
    virtual int read() override;  // flagged
};
