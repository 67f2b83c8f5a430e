// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <typeinfo>
struct Base {
    virtual ~Base();
};
bool same(Base& one, Base& other) {
    return typeid(one) == typeid(other);  // flagged
}
