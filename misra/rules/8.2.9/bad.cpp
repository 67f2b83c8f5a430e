// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <typeinfo>
struct Base {
    virtual ~Base();
};
bool same(Base& one, Base& other) {
    return typeid(one) == typeid(other);  // flagged
}
