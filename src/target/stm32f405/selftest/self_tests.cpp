// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/self_tests.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/core.hpp"

namespace canproof::stm32f405 {

static_assert(implements<req::CO_SELF_010>);
SelfTest SelfTests::start(const Instant now) noexcept {
    guard_.start();
    clock_.start(now);
    if (!core_registers_hold()) {
        return SelfTest::core;
    }
    return ram_.pass() ? SelfTest::none : SelfTest::ram;
}

static_assert(implements<req::CO_SELF_004> && implements<req::CO_SELF_006>);
SelfTest SelfTests::step(const Instant now) noexcept {
    if (!guard_.is_intact()) {
        return SelfTest::stack;
    }
    if (!clock_.step(now)) {
        return SelfTest::clock;
    }
    return take_turn();
}

static_assert(implements<req::CO_SELF_003>);
SelfTest SelfTests::take_turn() noexcept {
    SelfTest failed{SelfTest::none};
    switch (turn_) {
        case Turn::core:
            failed = core_registers_hold() ? SelfTest::none : SelfTest::core;
            turn_ = Turn::ram;
            break;
        case Turn::ram:
            failed = ram_.step() ? SelfTest::none : SelfTest::ram;
            turn_ = Turn::flash;
            break;
        case Turn::flash:
        default:
            failed = flash_.step() ? SelfTest::none : SelfTest::flash;
            turn_ = Turn::core;
            break;
    }
    return failed;
}

}  // namespace canproof::stm32f405
