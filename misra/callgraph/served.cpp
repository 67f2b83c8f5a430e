// SPDX-License-Identifier: Apache-2.0
// Functions for the test of the check in checks/served.py, which finds functions that implement no requirement. A
// comment names each function that the check must report.
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

[[gnu::noinline]] int called(const int value) {
    return value * 3;
}

[[gnu::noinline]] int stray(const int value) {  // the check must report: canproof::stray
    return value * 5;
}

}  // namespace

class Linked {
  public:
    explicit Linked(const int value) : value_{value} {}
    static_assert(implements<req::CO_NMT_001>);
    int declared() const;
    int forgotten() const;  // the check must report: canproof::Linked::forgotten

  private:
    int value_;
};

int Linked::declared() const {
    return called(value_);
}

int Linked::forgotten() const {
    return stray(value_);
}

static_assert(implements<req::CO_NMT_002>);
int above(const int value) {
    return Linked{value}.declared();
}

int inside(const int value) {
    static_assert(implements<req::CO_NMT_003>);
    return value + 1;
}

int dispatcher(const int value) {  // the check must report: canproof::dispatcher
    return above(value);
}

}  // namespace canproof
