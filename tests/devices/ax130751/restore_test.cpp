// SPDX-License-Identifier: Apache-2.0
// Tests that the AX130751 restores defaults group by group (manual, 3.2.8), and that a change of the configuration does
// not clear 1020h (verify configuration) (3.2.12).
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// One parameter of each group: 1017h (communication), 6340h:2 (application), 5032h (manufacturer).
struct Values {
    std::uint64_t heartbeat;
    std::uint64_t fault_mode;
    std::uint64_t hot;
    bool operator==(const Values& other) const {
        return heartbeat == other.heartbeat && fault_mode == other.fault_mode && hot == other.hot;
    }
};

class Ax130751Restore : public Ax130751Test {
  protected:
    static constexpr Values defaults{0, 1, 85};
    static constexpr Values changed{500, 0, 90};

    /// Stores values other than the defaults in each group.
    void store_changed() {
        EXPECT_EQ(write(0x1017, 0, 500, 2), "");
        EXPECT_EQ(write(0x6340, 2, 0, 1), "");
        EXPECT_EQ(write(0x5032, 0, 90, 1), "");
        store();
        power_on();
        EXPECT_EQ(values(), changed);
    }
    Values values() { return {read(0x1017, 0), read(0x6340, 2), read(0x5032, 0)}; }
    /// Returns the values expected after 1011h:`group` has restored defaults and the device was powered on again.
    static Values restored(int group) {
        return {group == 1 || group == 2 ? defaults.heartbeat : changed.heartbeat,
                group == 1 || group == 3 ? defaults.fault_mode : changed.fault_mode,
                group == 1 || group == 4 ? defaults.hot : changed.hot};
    }
};

}  // namespace

TEST_F(Ax130751Restore, EachRestoredParameterGroupGetsItsDefaultsAtPowerOn) {
    verifies<req::AOR_STORE_001, req::AOR_STORE_005, req::AOR_OD_1011, req::AOR_STORE_007>();
    EXPECT_EQ(values(), defaults);
    for (const bool operational : {false, true}) {
        for (int group = 1; group <= 4; ++group) {
            SCOPED_TRACE(fmt::format("group {}, operational {}", group, operational));
            store_changed();
            if (operational) {
                start();
            }
            EXPECT_EQ(write(0x1011, group, 0x64616F6C, 4), "");
            EXPECT_EQ(device->state(), operational ? NmtState::operational : NmtState::pre_operational);
            pass(1000);
            EXPECT_EQ(values(), changed) << "until the next reset";
            power_on();
            EXPECT_EQ(values(), restored(group));
            power_on();
            EXPECT_EQ(values(), restored(group)) << "it stays restored";
        }
    }
}

TEST_F(Ax130751Restore, CommunicationDefaultsApplyAtResetCommunicationAndOthersAtResetNode) {
    verifies<req::AOR_STORE_005, req::AOR_OD_1011>();
    for (int group = 1; group <= 4; ++group) {
        SCOPED_TRACE(group);
        store_changed();
        restore(group);
        EXPECT_EQ(send("000#827F").front(), "77F#00");
        EXPECT_EQ(values(), (Values{restored(group).heartbeat, changed.fault_mode, changed.hot})) << "communication";
        EXPECT_EQ(send("000#817F").front(), "77F#00");
        EXPECT_EQ(values(), restored(group));
    }
}

// AX130751, 3.2.12
TEST_F(Ax130751Restore, SoftwareDateAndTimeAreKeptWhenParametersAreWrittenOrRestored) {
    verifies<req::CO_VERIFY_003, req::AOR_OD_1020>();
    factory.made_on = 0x01022024;
    factory.made_at = 0x00001234;
    power_on();
    store_changed();
    restore();
    EXPECT_EQ(write(0x1017, 0, 1000, 2), "");
    EXPECT_EQ(write(0x1020, 2, 0x1235, 4), "06010002");
    EXPECT_EQ(read(0x1020, 1), 0x01022024U);
    EXPECT_EQ(read(0x1020, 2), 0x00001234U);
}

}  // namespace canproof::test
