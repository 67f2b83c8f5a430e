// SPDX-License-Identifier: Apache-2.0
// Tests 1020h verify configuration (CiA 301, 7.5.2.23), and that the TIME message has no effect, because no device has
// this service. The tests use the conformance slave, node 5, whose 1020h is writable, and the three devices whose 1020h
// shows the date of their software.
#include "devices/catalogue.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class VerifyConfiguration : public testing::Test, public SlaveBench {
  protected:
    void talk(const std::vector<Exchange>& table) { test::talk(static_cast<SlaveBench&>(*this), table); }
    /// Writes a date (day 30,000 = 7530h) and a time (43,200,000 ms = 02932E00h) to 1020h, as a configuration tool
    /// does.
    void leave_date_and_time() {
        talk({{"605#2320100130750000", {"585#6020100100000000"}}, {"605#23201002002E9302", {"585#6020100200000000"}}});
    }
    const std::vector<Exchange> kept{{"605#4020100100000000", {"585#4320100130750000"}},
                                     {"605#4020100200000000", {"585#43201002002E9302"}}};
    const std::vector<Exchange> zero{{"605#4020100100000000", {"585#4320100100000000"}},
                                     {"605#4020100200000000", {"585#4320100200000000"}}};
};

}  // namespace

TEST_F(VerifyConfiguration, DateAndTimeWrittenByAConfigurationToolAreKept) {
    verifies<req::CO_VERIFY_001, req::CO_VERIFY_004>();
    talk(zero);
    leave_date_and_time();
    talk(kept);
    talk({{"605#2310100173617665", {"585#6010100100000000"}}, {"000#8205", {"705#00"}}});
    talk(kept);
    send("000#8105");
    talk(kept);
    power_on();
    talk(kept);
}

TEST_F(VerifyConfiguration, ChangeOfAStoredValueClearsDateAndTime) {
    verifies<req::CO_VERIFY_002>();
    for (const Exchange& change :
         // 1017h producer heartbeat time, a communication parameter: 1000 ms
         {Exchange{"605#2B171000E8030000", {"585#6017100000000000"}},
          Exchange{"605#2F01200107000000", {"585#6001200100000000"}},     // 2001h:1 = 7; only TPDOs can carry 2001h
          Exchange{"605#2F01220008000000", {"585#6001220000000000"}}}) {  // 2201h = 8; no PDO can carry 2201h
        leave_date_and_time();
        talk({change});
        talk(zero);
    }
}

TEST_F(VerifyConfiguration, ChangeOfAStoredTextClearsDateAndTimeAndARewriteOfItDoesNot) {
    verifies<req::CO_VERIFY_002, req::CO_VERIFY_005>();
    const Exchange two_letters{"605#2B00230078790000", {"585#6000230000000000"}};  // 2300h = "xy"
    for (const Exchange& change : {Exchange{"605#2F00230078000000", {"585#6000230000000000"}}, two_letters}) {
        leave_date_and_time();
        talk({change});  // first 2300h changes from "abc" to "x", in the second round from "x" to "xy"
        talk(zero);
    }
    leave_date_and_time();
    talk({two_letters});
    talk(kept);
}

TEST_F(VerifyConfiguration, AccessThatChangesNoConfigurationKeepsDateAndTime) {
    verifies<req::CO_VERIFY_005>();
    leave_date_and_time();
    talk({{"605#2B17100000000000", {"585#6017100000000000"}},    // 1017h (producer heartbeat time) is 0 already
          {"605#2F29100103000000", {"585#8029100131000906"}},    // 1029h:1 (error behaviour) = 3: refused, too high
          {"605#2F00100000000000", {"585#8000100002000106"}},    // 1000h (device type) cannot be written
          {"605#2310100173617665", {"585#6010100100000000"}},    // 1010h:1 saves all parameters
          {"605#4000200100000000", {"585#4F00200100000000"}}});  // 2000h:1 is read
    talk(kept);
    send("080#01");  // a SYNC of wrong length is listed in 1003h (error list); the list is no configuration
    talk({{"605#4003100000000000", {"585#4F03100001000000"}}, {"605#2F03100000000000", {"585#6003100000000000"}}});
    talk(kept);
    send("000#0105");
    send("205#0708");  // RPDO1 sets 2000h:1 and 2000h:2
    talk({{"605#4000200100000000", {"585#4F00200107000000"}}});
    talk(kept);
}

TEST_F(VerifyConfiguration, WriteOfAProcessValueKeepsDateAndTime) {
    verifies<req::CO_VERIFY_005>();
    leave_date_and_time();
    // 2000h:1 = 7: RPDO1 carries 2000h:1, so it is a process value
    talk({{"605#2F00200107000000", {"585#6000200100000000"}},
          // 2200h = 50: an RPDO may carry 2200h, so it is a process value
          {"605#2B00220032000000", {"585#6000220000000000"}},
          // 2202h = 4.0: an RPDO may carry 2202h, so it is a process value
          {"605#2302220000008040", {"585#6002220000000000"}}});
    talk(kept);
}

TEST_F(VerifyConfiguration, DateAndTimeCanBeWrittenSeparately) {
    verifies<req::CO_VERIFY_001, req::CO_VERIFY_005>();
    leave_date_and_time();
    talk({{"605#2320100131750000", {"585#6020100100000000"}}, {"605#4020100200000000", {"585#43201002002E9302"}}});
}

// 1020h:1 has day, month and year, 1020h:2 hour and minute, as BCD: each decimal digit is one hexadecimal digit
// (AX130751 3.2.12, AX188001 3.2.12, AX060805 4.2.12).
TEST(VerifyConfigurationOfTheDevice, DateAndTimeAreReadOnlyAndKeptAfterAWriteOfTheHeartbeatTime) {
    verifies<req::CO_VERIFY_003>();
    for (const char* name : {"ax130751", "ax188001", "ax060805"}) {
        const auto device = host::make_device(name);
        ASSERT_NE(device, nullptr) << name;
        device->set_node_id(5);
        device->power_on(Instant{});
        const auto send = [&device](const std::string& frame) {
            while (!device->queue().empty()) {
                device->queue().pop();
            }
            device->receive(host::parse_frame(frame, "test"), Instant{});
            return device->queue().empty() ? std::string{} : host::format_frame(device->queue().pop());
        };
        const std::string date = send("605#4020100100000000");
        EXPECT_EQ(date.substr(0, 12), "585#43201001") << name;
        EXPECT_NE(date.substr(12), "00000000") << name;
        const std::string time = send("605#4020100200000000");
        EXPECT_EQ(time.substr(0, 12), "585#43201002") << name;
        EXPECT_EQ(send("605#2B171000E8030000"), "585#6017100000000000") << name;  // heartbeat every second
        EXPECT_EQ(send("605#4020100100000000"), date) << name;
        EXPECT_EQ(send("605#4020100200000000"), time) << name;
        EXPECT_EQ(send("605#2320100100000000"), "585#8020100102000106") << name;
        EXPECT_EQ(send("605#2320100278560000"), "585#8020100202000106") << name;
        EXPECT_EQ(send("605#4020100100000000"), date) << name;
        EXPECT_EQ(send("605#4020100200000000"), time) << name;
    }
}

// CAN-CBX-AO412, 7.10.2.3: how an SDO write sets output 1 to 5 V. 7.9.20: the firmware does not use the values of
// 1020h.
TEST(VerifyConfigurationOfTheCbx, DateIsKeptByAnOutputWriteAndClearedByAConfigurationWrite) {
    verifies<req::CO_VERIFY_002, req::CO_VERIFY_005, req::AO4_OD_1020>();
    CbxBench bench;
    bench.power_on();
    const Frames date{"583#4320100130750000"};
    bench.write("603#2320100130750000");
    bench.write("603#2B116401B33E0000");  // telegram example 1: 3EB3h
    EXPECT_NEAR(bench.volts(1), 5.0F, 0.005F);
    EXPECT_EQ(bench.send("603#4020100100000000"), date);
    bench.write("603#2B171000E8030000");  // heartbeat every second
    EXPECT_EQ(bench.send("603#4020100100000000"), Frames{"583#4320100100000000"});
}

// CiA 301, 7.2.6: TIME has six bytes and the identifier 100h
TEST_F(VerifyConfiguration, TimeMessageHasNoEffect) {
    verifies<req::CO_TIME_001>();
    leave_date_and_time();
    talk({{"100#002E93023075", {}}, {"100#", {}}, {"100#R", {}}, {"605#4012100000000000", {"585#8012100000000206"}}});
    talk(kept);
    send("000#0105");
    talk({{"100#002E93023075", {}}});
    EXPECT_EQ(device->node().state(), NmtState::operational);
}

TEST_F(VerifyConfiguration, FrameOn100hIsASyncWhile1005hHasThisIdentifier) {
    verifies<req::CO_TIME_001, req::CO_SYNC_001>();
    EXPECT_EQ(send("605#2305100000010000"), (Frames{"585#6005100000000000"}));  // 1005h (COB-ID SYNC) = 100h
    send("000#0105");
    EXPECT_EQ(send("100#"), (Frames{"285#0000000000000000"}));  // TPDO2 is of type 1: each SYNC sends it
}

}  // namespace canproof::test
