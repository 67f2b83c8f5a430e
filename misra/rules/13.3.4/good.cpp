// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    virtual void read();
};
bool none(void (Base::*call)()) { return call == nullptr; }
