// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    virtual int read(int value);
};
struct Derived : Base {
    int read(int value) override;
};
