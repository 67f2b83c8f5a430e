// SPDX-License-Identifier: Apache-2.0
// Tests supply and temperature faults of the AX130751, which begin at one limit and end at another (hysteresis)
// (manual, 1.8).
#include "devices/ax130751/firmware/limit_fault.hpp"

#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax130751;

/// Advances an under-voltage fault. With the default thresholds it begins below 8 V and ends at 13 V. Returns whether
/// it is active.
bool under(LimitFault& fault, double volts, bool enabled = true) {
    return fault.advance(enabled, volts < 8.0, volts >= 13.0);
}

}  // namespace

TEST(LimitFault, FaultBeginsBeyondTheLimitAndEndsAtTheHysteresis) {
    verifies<req::AOR_DIAG_002, req::AOR_DIAG_015>();
    LimitFault fault;
    EXPECT_FALSE(under(fault, 12.0));
    EXPECT_FALSE(under(fault, 8.0));
    EXPECT_TRUE(under(fault, 7.9));
    EXPECT_TRUE(under(fault, 12.9));
    EXPECT_FALSE(under(fault, 13.0));
    EXPECT_FALSE(under(fault, 8.0));
}

TEST(LimitFault, FaultEndsWhenItsDetectionIsSwitchedOff) {
    verifies<req::AOR_DIAG_011>();
    LimitFault fault;
    EXPECT_TRUE(under(fault, 5.0));
    EXPECT_FALSE(under(fault, 5.0, false));
    EXPECT_FALSE(fault.is_present());
    EXPECT_FALSE(under(fault, 12.0));
}

}  // namespace canproof::test
