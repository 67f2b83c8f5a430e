// SPDX-License-Identifier: Apache-2.0
// Gives a CAN-CBX-AO412 the most work in one call: all its timers end while two synchronous RPDOs wait, after a
// disturbance of the bus during which emergency messages have waited.
// When these tests run on the microcontroller, src/target/run_suites measures the longest frame and cycle.
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/disturbed_bus.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class CbxLoad : public DisturbedBus<CbxTest> {
  protected:
    void SetUp() override {
        CbxTest::SetUp();
        write("603#2B17100064000000");  // 1017h (producer heartbeat time): 100 ms
        write("603#2316100164003100");  // 1016h:1 (consumer heartbeat time): node 31h, 100 ms
        for (const char* const output : {"01", "02", "03", "04"}) {
            write(std::string{"603#2F4364"} + output +
                  "01000000");  // 6443h: in an error the output takes its error value,
            write(std::string{"603#234464"} + output + "00000060");  // 6444h: 6000h, 3072 steps
        }
        write("603#2F29100101000000");  // 1029h:1 (error behaviour): no change
        // RPDO2 and RPDO3 are synchronous and carry all four outputs.
        for (const char* const at : {"01", "02"}) {
            const std::string pdo = std::string{at} + "14";
            const std::string mapping = std::string{at} + "16";
            const std::string cob_id = std::string{"03"} + (at[1] == '1' ? "03" : "04");
            send("603#23" + pdo + "01" + cob_id + "0080");
            send("603#2F" + pdo + "0200000000");
            send("603#2F" + mapping + "0000000000");
            for (int line = 1; line <= 4; ++line) {
                send("603#23" + mapping + "0" + std::to_string(line) + "100" + std::to_string(line) + "1164");
            }
            send("603#2F" + mapping + "0004000000");
            write("603#23" + pdo + "01" + cob_id + "0000");
        }
        send("000#0103");
        send("731#05");
        pass(50);
        receive_pdos();
        send_alone("080#");
        pass(40);
        receive_pdos();
        pass(9);
    }
    /// Lets the errors of the controller, the device and the SYNC begin and end twice while the device can send
    /// nothing. This takes no time.
    void disturb() {
        disturb_bus();
        for (const bool fails : {true, false, true, false}) {
            fail_controller(fails);
            inputs.internal_fault = fails;
            inputs.hardware_fault = fails;
            set_inputs();
            send_alone(fails ? "080#01" : "080#");
        }
    }
    void receive_pdos() {
        send("303#0020002000200020");  // 2000h = 8192: 1024 steps
        send("403#0040004000400040");  // 4000h = 16384: 2048 steps
    }
};

}  // namespace

TEST_F(CbxLoad, OutputsTakeTheirErrorValuesWhenAllTimersEnd) {
    verifies<req::AO4_AOUT_006, req::AO4_AOUT_007>();
    const float commanded = volts(1);
    EXPECT_GT(commanded, 0.0F) << "4000h = 16384: 2048 steps";
    const Frames frames = pass(1);
    EXPECT_EQ(frames.size(), 2U) << "the first lost heartbeat, and a heartbeat";
    for (const int output : {1, 2, 3, 4}) {
        EXPECT_GT(volts(output), commanded) << output << ": 3072 steps instead of 2048";
    }
}

TEST_F(CbxLoad, WriteThatComesWhenAllTimersEndFindsTheOutputsAtTheirErrorValues) {
    verifies<req::AO4_AOUT_006, req::AO4_AOUT_007>();
    const float commanded = volts(1);
    now = now + milliseconds(1);
    const Frames frames = send("603#2B04240100100000");  // 2404h:1 (calibration offset)
    EXPECT_EQ(frames.size(), 3U) << "the first lost heartbeat, the answer and a heartbeat";
    EXPECT_GT(volts(1), volts(2)) << "the offset of output 1";
    EXPECT_GT(volts(2), commanded);
}

// Overrun, error passive, internal fault, hardware fault and the length of a SYNC have begun and ended; the error of
// the lost heartbeat begins. The device reports no late RPDO.
TEST_F(CbxLoad, DisturbanceIsReportedWhenAllTimersEnd) {
    verifies<req::AO4_AOUT_006, req::CO_EMCY_006>();
    disturb();
    receive_pdos();
    free_bus(20);
    const Frames frames = pass(1);
    EXPECT_EQ(frames.size(), 20U + 11U + 1U) << "11 emergency messages and a heartbeat";
}

TEST_F(CbxLoad, StartSendsAllMessagesThatWaitedInStopped) {
    verifies<req::CO_EMCY_004, req::CO_EMCY_006>();
    disturb();
    send("000#0203");
    pass(5);
    free_bus(20);
    EXPECT_EQ(send_alone("000#0103").size(), 20U + 11U) << "begin and end of five errors, and the lost heartbeat";
}

TEST_F(CbxLoad, SyncThatTakesTwoRpdosReportsItsLength) {
    verifies<req::CO_PDO_002, req::AO4_AOUT_005>();
    send("080#01");
    receive_pdos();
    free_bus(30);
    EXPECT_EQ(send_alone("080#").size(), 31U) << "the error of its length ends";
    EXPECT_GT(volts(1), 0.0F);
}

TEST_F(CbxLoad, FrameOfTwoRpdosDrivesTheOutputs) {
    verifies<req::CO_PDO_059, req::AO4_AOUT_005>();
    for (const char* const at : {"01", "02"}) {
        const std::string pdo = std::string{at} + "14";
        send("603#23" + pdo + "0103030080");
        send("603#2F" + pdo + "02FF000000");
        write("603#23" + pdo + "0103030000");
    }
    send_alone("731#05");
    free_bus(30);
    EXPECT_EQ(send_alone("303#0030003000300030").size(), 30U);
    EXPECT_GT(volts(4), 0.0F);
}

}  // namespace canproof::test
