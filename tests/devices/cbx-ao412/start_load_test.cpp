// SPDX-License-Identifier: Apache-2.0
// Gives a CAN-CBX-AO412 the most work of a power-on and of a reset: two sound sets of parameters, of which the newer
// cannot be read to its end. When these tests run on the microcontroller, src/target/run_suites measures this work.
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/unreadable_set.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class CbxStartLoad : public UnreadableSet<CbxBench, 1024> {
  protected:
    void SetUp() override {
        power_cycle();
        write("603#2B171000F4010000");  // 1017h (producer heartbeat time): 500 ms
        store_two_sets([this] { write("603#2310100173617665"); });
    }
    void expect_heartbeat_time(const std::string& bytes) {
        EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B171000" + bytes + "0000"}));
    }
    /// Sets all errors that a start can report, and values of one unit. The clock shows 142 years, because the
    /// divisions of the LEDs take longest with such a time.
    void fail_everything() {
        now = Instant{std::uint64_t{1} << 52U};
        inputs.can_overrun = true;
        inputs.can_state = 2;
        inputs.internal_fault = true;
        inputs.hardware_fault = true;
        factory.hardware_version = {'9', '.', '0', '0'};
        factory.software_version = {'9', '.', '9', '9'};
        factory.software_date = 11U;
        factory.software_time = 12U;
        factory.revision = 13U;
        factory.serial_number = 14U;
        factory.offset = {1, 2, 3, 4};
        factory.gain = {5, 6, 7, 8};
        power_cycle();
    }
    /// Expects the boot-up message and the messages of overrun, error passive, software and hardware.
    void expect_all_errors(const Frames& frames) {
        ASSERT_EQ(frames.size(), 5U);
        EXPECT_EQ(frames.at(0), "703#00");
        EXPECT_EQ(frames.at(1).substr(0, 8), "083#1081");
        EXPECT_EQ(frames.at(2).substr(0, 8), "083#2081");
        EXPECT_EQ(frames.at(3).substr(0, 8), "083#1061");
        EXPECT_EQ(frames.at(4).substr(0, 8), "083#0050");
        expect_heartbeat_time("0000");
        EXPECT_EQ(send("603#4018100400000000"), (Frames{"583#431810040E000000"})) << "the serial number of the unit";
        EXPECT_EQ(send("603#4003100000000000"), (Frames{"583#4F03100005000000"})) << "with the damaged values";
    }
    /// Expects the boot-up message and the emergency message of damaged stored values, and the default parameters.
    void expect_defaults(const Frames& frames) {
        EXPECT_EQ(frames.front(), "703#00");
        EXPECT_EQ(frames.at(1).substr(0, 8), "083#1061") << "internal software: damaged stored values";
        expect_heartbeat_time("0000");
    }
};

}  // namespace

TEST_F(CbxStartLoad, PowerOnWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::AO4_ERR_018>();
    expect_defaults(with_unreadable_value([this] { return power_cycle(); }));
    power_cycle();
    expect_heartbeat_time("F401");
}

TEST_F(CbxStartLoad, ResetWithAnUnreadableLastValueUsesTheDefaults) {
    verifies<req::CO_STORE_006, req::CO_STORE_016, req::AO4_ERR_018>();
    expect_defaults(with_unreadable_value([this] { return send("000#8103"); }));
    send("000#8103");
    expect_heartbeat_time("F401");
}

TEST_F(CbxStartLoad, PowerOnWithAnUnreadableLastValueReportsAllErrors) {
    verifies<req::CO_STORE_016, req::AO4_ERR_018, req::AO4_ERR_009, req::AO4_ERR_010>();
    fail_everything();
    expect_all_errors(with_unreadable_value([this] { return power_cycle(); }));
}

TEST_F(CbxStartLoad, ResetWithAnUnreadableLastValueReportsAllErrors) {
    verifies<req::CO_STORE_016, req::AO4_ERR_018, req::AO4_ERR_009, req::AO4_ERR_010>();
    fail_everything();
    expect_all_errors(with_unreadable_value([this] { return send("000#8103"); }));
}

}  // namespace canproof::test
