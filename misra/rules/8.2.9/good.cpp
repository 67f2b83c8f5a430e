// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Base {
    virtual int kind();
};
bool same(Base& one, Base& other) { return one.kind() == other.kind(); }
