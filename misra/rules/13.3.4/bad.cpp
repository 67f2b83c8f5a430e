// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Base {
    virtual void read();
    virtual void write();
};
bool same(void (Base::*call)()) {
    return call == &Base::read;  // flagged
}
