// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Base {
    virtual void read();
    virtual void write();
};
bool same(void (Base::*call)()) {
    return call == &Base::read;  // flagged
}
