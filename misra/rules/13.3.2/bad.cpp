// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    virtual int read(int value = 3);  // flagged
};
struct Derived : Base {
    int read(int value = 4) override;  // flagged
};
