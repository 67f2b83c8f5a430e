// SPDX-License-Identifier: Apache-2.0
// Tests the values that an AX060805 receives by RPDO and uses as sources of its functions (manual, 3.10.1, 4.3.19 to
// 4.3.21), node 127.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_functions.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805ReceivedValues : public InclinometerFunctions {};

/// RPDO1 sets received value 1, RPDO2 sets received value 3.
class Ax060805TwoRpdos : public Ax060805ReceivedValues {
  protected:
    void SetUp() override {
        Ax060805ReceivedValues::SetUp();
        map_rpdo1(0x25000110);
        write(0x1601, 1, 0x25000310, 4);
        write(0x1601, 0, 1, 1);
        write(0x1401, 1, 0x4000037F, 4);
        write(0x1029, 1, 1, 1);  // 1029h:1 error behaviour: the node stays operational
        send("000#0100");
    }
    void map_rpdo1(std::uint32_t entry) {
        write(0x1400, 1, 0xC000027F, 4);
        write(0x1600, 0, 0, 1);
        write(0x1600, 1, entry, 4);
        write(0x1600, 0, 1, 1);
        write(0x1400, 1, 0x4000027F, 4);
    }
};

}  // namespace

TEST_F(Ax060805ReceivedValues, ReceivedValueOf45Means45DegreesAsShipped) {
    verifies<req::INC_RPDO_001, req::INC_OD_2501, req::INC_SIG_005>();
    send("000#0100");
    send("27F#2D0000000000");  // received value 1 is 2Dh = 45
    EXPECT_EQ(taken_from(20, 1.0F), 45);
    operate(1, 10);  // operation 10: pitch > limit
    connect(1, 1, 5);
    connect(1, 2, 20);
    turn(44.9, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 0);
    turn(45.1, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 1);
    send("27F#D3FF00000000");  // FFD3h = -45
    turn(-45.1, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 0);
    turn(-44.9, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 1);
}

// Section 4.3.20: the number of counts per unit is 1000 divided by 2501h (RPDO Decimal Digits).
TEST_F(Ax060805ReceivedValues, RpdoDecimalDigits2501hGiveTheCountsPerUnitOfAReceivedValue) {
    verifies<req::INC_RPDO_001, req::INC_OD_2501, req::INC_OD_2502>();
    write(0x2500, 3, 4500, 2);
    EXPECT_EQ(taken_from(22, 1.0F), 4500);
    write(0x2501, 3, 100, 2);
    EXPECT_EQ(taken_from(22, 1.0F), 450);
    write(0x2501, 3, 10, 2);
    EXPECT_EQ(taken_from(22, 1.0F), 45);
    write(0x2501, 3, 500, 2);  // 2 counts per unit
    EXPECT_EQ(taken_from(22, 1.0F), 2250);
    write_real(0x2502, 3, -500.0F);  // the offset is in counts
    EXPECT_EQ(taken_from(22, 1.0F), 2000);
}

TEST_F(Ax060805ReceivedValues, FunctionComparesAnAngleWithAReceivedLimit) {
    verifies<req::INC_RPDO_001, req::INC_SIG_005, req::INC_FV_008, req::INC_FV_009, req::INC_FV_005, req::INC_OD_2500,
             req::INC_OD_2501, req::INC_OD_2502>();
    operate(1, 10);  // operation 10: pitch > limit
    connect(1, 1, 5);
    connect(1, 2, 20);
    write(0x2501, 1, 100, 2);     // received counts are tenths of a degree
    write_real(0x2502, 1, 5.0F);  // an offset of 5 counts adds half a degree to the received value
    // 2040h:1 (offset of the pitch) changes the field value of the pitch, but not the signal that the function gets
    write_real(0x2040, 1, 100.0F);
    write(0x2500, 1, 200, 2);  // the limit is 200 tenths + 0.5 = 20.5 degrees
    turn(20.4, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 0);
    EXPECT_EQ(pitch(), 120);
    turn(20.6, 0.0);
    pass(5);
    EXPECT_EQ(output(1), 1);
    write(0x2031, 1, 1, 1);
    pass(5);
    EXPECT_EQ(output(1), 0);  // -20.6 is below the limit
    EXPECT_EQ(refusal(0x2501, 1, 9, 2), "06090032");
    EXPECT_EQ(refusal(0x2501, 1, 1001, 2), "06090031");
    EXPECT_EQ(refusal(0x2502, 1, bits_of(1.0e10F), 4), "06090031");
    EXPECT_EQ(refusal(0x2502, 1, bits_of(-1.0e10F), 4), "06090032");
}

TEST_F(Ax060805ReceivedValues, ReceivedValueIsUndefinedUntilAnRpdoOrAnSdoWriteSetsIt) {
    verifies<req::INC_RPDO_002, req::INC_SIG_002, req::INC_OD_2500>();
    EXPECT_EQ(taken_from(21, 1.0F), undefined);
    send("000#0100");
    send("27F#0000D0070000");  // received value 2 is 7D0h = 2000
    EXPECT_EQ(taken_from(21, 1.0F), 2000);
    EXPECT_EQ(taken_from(20, 1.0F), 0);  // received value 1, undefined before, is 0 in this frame
    send("000#8100");
    EXPECT_EQ(value(0x2500, 2), 0);
    switch_filter_off();
    EXPECT_EQ(taken_from(21, 1.0F), undefined);
    write(0x2500, 2, 3000, 2);
    EXPECT_EQ(taken_from(21, 1.0F), 3000);
}

TEST_F(Ax060805ReceivedValues, ReceivedValueIsUndefinedFromAnRpdoTimeOutUntilItIsSetAgain) {
    verifies<req::INC_RPDO_003>();
    write(0x1400, 5, 100, 2);
    write(0x1029, 1, 1, 1);  // 1029h:1 error behaviour: the node stays operational
    send("000#0100");
    send("27F#E80300000000");  // 3E8h = 1000
    EXPECT_EQ(taken_from(20, 1.0F), 1000);
    pass(100);
    EXPECT_EQ(taken_from(20, 1.0F), undefined);
    EXPECT_EQ(value(0x2500, 1), 1000);
    write(0x2500, 1, 4000, 2);
    EXPECT_EQ(taken_from(20, 1.0F), 4000);
    send("27F#D00700000000");
    EXPECT_EQ(taken_from(20, 1.0F), 2000);
}

TEST_F(Ax060805ReceivedValues, ValueReceivedWhileAnotherRpdoIsLateIsUsedUntilItsOwnRpdoIsLate) {
    verifies<req::INC_RPDO_003>();
    write(0x1400, 5, 100, 2);
    write(0x1601, 1, 0x25000210, 4);
    write(0x1601, 0, 1, 1);
    write(0x1401, 5, 300, 2);
    write(0x1401, 1, 0x4000037F, 4);
    write(0x1029, 1, 1, 1);  // 1029h:1 error behaviour: the node stays operational
    send("000#0100");
    send("27F#E80300000000");
    pass(100);  // RPDO1 is overdue from here on
    EXPECT_EQ(taken_from(21, 1.0F), undefined);
    send("37F#D007");  // RPDO2 brings 2000
    EXPECT_EQ(taken_from(21, 1.0F), 2000);
    pass(300);
    EXPECT_EQ(taken_from(21, 1.0F), undefined);
}

TEST_F(Ax060805ReceivedValues, ReceivedValueWrittenBySdoAfterTheRpdoTimeOutIsUsed) {
    verifies<req::INC_RPDO_003>();
    write(0x1400, 5, 100, 2);
    write(0x1029, 1, 1, 1);
    send("000#0100");
    pass(2);  // RPDO1 will be late at 102 ms, between the samples at 100 and 105 ms
    send("27F#E80300000000");
    pass(101);
    write(0x2500, 1, 4000, 2);
    EXPECT_EQ(taken_from(20, 1.0F), 4000);
}

// RPDO1 is late at 102 ms and comes at 103 ms, between the samples at 100 and 105 ms
TEST_F(Ax060805TwoRpdos, RpdoThatIsLateOnlyBetweenTwoSamplesInvalidatesTheValuesOfTheOtherRpdo) {
    verifies<req::INC_RPDO_003>();
    write(0x1400, 5, 100, 2);
    send("37F#D007");
    EXPECT_EQ(taken_from(22, 1.0F), 2000);
    pass(2);
    send("27F#E803");
    pass(101);
    send("27F#E803");
    EXPECT_EQ(taken_from(22, 1.0F), undefined);
    EXPECT_EQ(taken_from(20, 1.0F), 1000);
}

TEST_F(Ax060805TwoRpdos, RpdoThatIsLateAgainBeforeTheNextSampleInvalidatesTheValuesAgain) {
    verifies<req::INC_RPDO_003>();
    map_rpdo1(0x00050008);  // RPDO1 maps only a dummy entry
    write(0x1400, 5, 2, 2);
    send("27F#00");
    pass(5);           // RPDO1 is late
    send("37F#D007");  // RPDO2 sets received value 3 to 2000 while RPDO1 is late
    EXPECT_EQ(taken_from(22, 1.0F), 2000);
    pass(1);
    send("27F#00");
    pass(4);  // RPDO1 came at 6 ms and is late again at 8 ms, before the sample at 10 ms
    EXPECT_EQ(taken_from(22, 1.0F), undefined);
}

// RPDO1 arrives after its time-out, but before the call in which the device detects the time-out.
TEST_F(Ax060805TwoRpdos, RpdoArrivingAfterItsTimeOutInvalidatesTheValuesOfTheOtherRpdo) {
    verifies<req::INC_RPDO_003>();
    write(0x1400, 5, 20, 2);
    send("37F#D007");
    EXPECT_EQ(taken_from(22, 1.0F), 2000);
    pass(1);
    send("27F#E803");
    now = now + milliseconds(21);  // RPDO1 has become late after 20 ms, but the device was not called then
    send("27F#E803");
    EXPECT_EQ(taken_from(22, 1.0F), undefined);
    EXPECT_EQ(taken_from(20, 1.0F), 1000);
}

}  // namespace canproof::test
