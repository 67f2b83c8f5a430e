// SPDX-License-Identifier: Apache-2.0
// Needs symbols that the firmware must not need: the heap, exceptions, run-time type information, floating-point traps.
#include <cfenv>

struct Base {
    virtual int read();
};
struct Derived : Base {
    int kept;
};

int use(Base* const base) {
    if (base == nullptr) {
        throw 3;
    }
    const auto* const derived = dynamic_cast<Derived*>(base);
    return (derived == nullptr) ? *new int(4) : derived->kept;
}

int trap() {
    return feenableexcept(FE_DIVBYZERO);
}
