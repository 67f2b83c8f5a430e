// SPDX-License-Identifier: Apache-2.0
// Life guarding of the AX188001 (manual, 3.2.5, 3.2.6): 100Ch (Guard Time) times 100Dh (Life Time Factor) is the life
// time. The tests use 100 ms * 2 = 200 ms.
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax188001Guarding : public TcsTest {
  protected:
    void set_life_time(std::uint32_t guard_time, std::uint32_t factor) {
        EXPECT_EQ(write(0x100C, 0, 2, guard_time), 0U);
        EXPECT_EQ(write(0x100D, 0, 1, factor), 0U);
    }
};

const Frames life_guarding_error{"1:0FF#3081010010000000"};

}  // namespace

TEST_F(Ax188001Guarding, MissingGuardingRequestIsAnErrorAfterTheLifeTime) {
    verifies<req::TCS_GUARD_002>();
    set_life_time(100, 2);
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    EXPECT_EQ(pass(199), Frames{});
    EXPECT_EQ(pass(1), life_guarding_error);
    EXPECT_EQ(send("77F#R"), (Frames{"0FF#0000000000000000", "77F#FF"}));
    EXPECT_EQ(pass(199), Frames{});
    EXPECT_EQ(pass(1), life_guarding_error);
}

TEST_F(Ax188001Guarding, GuardingRequestsBeginNoMonitoringWithAGuardTimeOrFactorOfZero) {
    verifies<req::TCS_GUARD_001>();
    for (const auto& [guard_time, factor] : {std::pair{100U, 0U}, {0U, 2U}, {0U, 0U}}) {
        power_on();
        set_life_time(guard_time, factor);
        EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
        EXPECT_EQ(pass(70000), Frames{}) << guard_time << " ms times " << factor;
    }
}

/// A client writes 0 in the middle of a life time, and no further request comes.
TEST_F(Ax188001Guarding, GuardTimeOrFactorOfZeroEndsRunningMonitoring) {
    verifies<req::TCS_GUARD_001>();
    for (const bool factor : {false, true}) {
        power_on();
        set_life_time(100, 2);
        EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
        pass(100);
        EXPECT_EQ(write(factor ? 0x100D : 0x100C, 0, factor ? 1 : 2, 0), 0U);
        EXPECT_EQ(pass(70000), Frames{}) << (factor ? "100Dh" : "100Ch");
    }
}

TEST_F(Ax188001Guarding, HeartbeatEndsRunningMonitoringOfGuardingRequests) {
    verifies<req::TCS_GUARD_003>();
    set_life_time(100, 2);
    EXPECT_EQ(send("77F#R"), (Frames{"77F#7F"}));
    pass(100);
    EXPECT_EQ(write(0x1017, 0, 2, 1000), 0U);
    EXPECT_EQ(pass(2500), (Frames{"1000:77F#7F", "2000:77F#7F"}));
    EXPECT_EQ(read(0x1001, 0).value, 0U);
}

TEST_F(Ax188001Guarding, GuardingRequestsBeginNoMonitoringDuringAHeartbeat) {
    verifies<req::TCS_GUARD_003>();
    set_life_time(100, 2);
    EXPECT_EQ(write(0x1017, 0, 2, 1000), 0U);
    EXPECT_EQ(send("77F#R"), Frames{});
    EXPECT_EQ(pass(999), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:77F#7F"}));
}

}  // namespace canproof::test
