// SDO server, expedited and segmented (CiA 301, 7.2.4), on a CAN-CBX-AO412 as node 3.
#include "support/bench.hpp"
#include "support/verifies.hpp"

namespace canproof::test {

using Sdo = CbxTest;

TEST_F(Sdo, ExpeditedUploadShowsItsLength) {
    verifies<req::CO_SDO_001, req::CO_K_SDO_REQUEST_ID, req::CO_K_SDO_RESPONSE_ID>();
    EXPECT_EQ(send("603#4001100000000000"), (Frames{"583#4F01100000000000"}));  // one byte
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));  // two
    EXPECT_EQ(send("603#4000100000000000"), (Frames{"583#4300100091010800"}));  // four
}

TEST_F(Sdo, SegmentedUploadOfTheDeviceName) {
    verifies<req::CO_SDO_002>();
    // "CAN-CBX-AO412" has 13 bytes: 7 and 6
    EXPECT_EQ(send("603#4008100000000000"), (Frames{"583#410810000D000000"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#0043414E2D434258"}));  // CAN-CBX
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#132D414F34313200"}));  // -AO412, one unused, last
}

TEST_F(Sdo, ExpeditedDownloadWithAndWithoutItsSize) {
    verifies<req::CO_SDO_003, req::CO_SDO_016>();
    EXPECT_EQ(send("603#2B171000E8030000"), (Frames{"583#6017100000000000"}));
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B171000E8030000"}));
    EXPECT_EQ(send("603#22171000D0070000"), (Frames{"583#6017100000000000"}));
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B171000D0070000"}));
    EXPECT_EQ(send("603#2F0D100007000000"), (Frames{"583#600D100000000000"}));
    EXPECT_EQ(send("603#400D100000000000"), (Frames{"583#4F0D100007000000"}));
    EXPECT_EQ(send("603#2320100178563412"), (Frames{"583#6020100100000000"}));
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100178563412"}));
}

TEST_F(Sdo, SegmentedDownloadSetsTheValueWithItsLastSegment) {
    verifies<req::CO_SDO_004>();
    EXPECT_EQ(send("603#2120100104000000"), (Frames{"583#6020100100000000"}));
    // two bytes, five unused: byte 0 = 0 | 5 << 1
    EXPECT_EQ(send("603#0A34120000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_EQ(send("603#1B78560000000000"), (Frames{"583#3000000000000000"}));  // toggle, five unused, last
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100134127856"}));
}

TEST_F(Sdo, SegmentedDownloadWithoutSize) {
    verifies<req::CO_SDO_004>();
    EXPECT_EQ(send("603#2017100000000000"), (Frames{"583#6017100000000000"}));
    EXPECT_EQ(send("603#0BE8030000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B171000E8030000"}));
}

TEST_F(Sdo, ToggleMustAlternate) {
    verifies<req::CO_SDO_005, req::CO_E_ABORT>();
    send("603#4008100000000000");
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#8008100000000305"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));  // the transfer is over
    send("603#2120100104000000");
    EXPECT_EQ(send("603#1A34120000000000"), (Frames{"583#8020100100000305"}));
}

TEST_F(Sdo, UnknownSpecifiersAndStraySegments) {
    verifies<req::CO_SDO_006, req::CO_E_ABORT>();
    EXPECT_EQ(send("603#E000100000000000"), (Frames{"583#8000100001000405"}));
    EXPECT_EQ(send("603#A000100000000000"), (Frames{"583#8000100001000405"}));  // block upload is not offered
    EXPECT_EQ(send("603#C200100000000000"), (Frames{"583#8000100001000405"}));  // nor block download
    EXPECT_EQ(send("603#0011223344556677"), (Frames{"583#8000000001000405"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));
    send("603#4008100000000000");
    EXPECT_EQ(send("603#0011223344556677"), (Frames{"583#8008100001000405"}));  // download segment in an upload
}

TEST_F(Sdo, FramesOfOtherThanEightBytesAreIgnored) {
    verifies<req::CO_SDO_007>();
    EXPECT_TRUE(send("603#40001000000000").empty());
    EXPECT_TRUE(send("603#2B171000E803").empty());
    EXPECT_TRUE(send("603#").empty());
    EXPECT_TRUE(send("603#R8").empty());
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));
}

TEST_F(Sdo, AbsentObjectsAndSubIndices) {
    verifies<req::CO_SDO_008, req::CO_E_ABORT>();
    EXPECT_EQ(send("603#4034120000000000"), (Frames{"583#8034120000000206"}));
    EXPECT_EQ(send("603#2B34120000000000"), (Frames{"583#8034120000000206"}));
    EXPECT_EQ(send("603#4011640500000000"), (Frames{"583#8011640511000906"}));
    EXPECT_EQ(send("603#4000100100000000"), (Frames{"583#8000100111000906"}));
    EXPECT_EQ(send("603#2117400002000000"), (Frames{"583#8017400000000206"}));
}

TEST_F(Sdo, ReadOnlyEntriesCannotBeWritten) {
    verifies<req::CO_SDO_009, req::CO_E_ABORT>();
    EXPECT_EQ(send("603#2300100000000000"), (Frames{"583#8000100002000106"}));
    EXPECT_EQ(send("603#2F11640004000000"), (Frames{"583#8011640002000106"}));  // sub 0
    EXPECT_EQ(send("603#210810000D000000"), (Frames{"583#8008100002000106"}));
}

TEST_F(Sdo, LengthsMustFit) {
    verifies<req::CO_SDO_010, req::CO_SDO_011, req::CO_E_ABORT>();
    EXPECT_EQ(send("603#2317100001000000"), (Frames{"583#8017100012000706"}));  // four bytes into two
    EXPECT_EQ(send("603#2F17100001000000"), (Frames{"583#8017100013000706"}));  // one byte
    EXPECT_EQ(send("603#2117100003000000"), (Frames{"583#8017100012000706"}));  // three announced
    send("603#2117100001000000");                                               // one announced, two sent
    EXPECT_EQ(send("603#0BE8030000000000"), (Frames{"583#8017100010000706"}));
    send("603#2017100000000000");
    EXPECT_EQ(send("603#01E8030000000000"), (Frames{"583#8017100012000706"}));  // seven bytes into two
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));
}

TEST_F(Sdo, ANewInitiateAbandonsTheTransfer) {
    verifies<req::CO_SDO_012>();
    send("603#2120100104000000");
    send("603#0A34120000000000");
    EXPECT_EQ(send("603#4000100000000000"), (Frames{"583#4300100091010800"}));
    EXPECT_EQ(send("603#1B78560000000000"), (Frames{"583#8000000001000405"}));
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100100000000"}));
}

TEST_F(Sdo, TheClientsAbortIsNotAnswered) {
    verifies<req::CO_SDO_013>();
    send("603#4008100000000000");
    EXPECT_TRUE(send("603#8008100000000405").empty());
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));
}

TEST_F(Sdo, AStalledTransferIsAbortedAfterOneSecond) {
    verifies<req::CO_SDO_014, req::CO_K_SDO_TIMEOUT>();
    send("603#4008100000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:583#8008100000000405"}));
    EXPECT_TRUE(pass(5000).empty());
}

TEST_F(Sdo, EachSegmentRestartsTheTimeOut) {
    verifies<req::CO_SDO_014>();
    send("603#4008100000000000");
    pass(900);
    send("603#6000000000000000");
    EXPECT_TRUE(pass(900).empty());
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#132D414F34313200"}));
}

TEST_F(Sdo, ARefusedWriteChangesNothing) {
    verifies<req::CO_SDO_011>();
    EXPECT_EQ(send("603#2F43640103000000"), (Frames{"583#8043640130000906"}));
    EXPECT_EQ(send("603#4043640100000000"), (Frames{"583#4F43640101000000"}));
}

TEST_F(Sdo, ServedInPreOperationalAndOperationalOnly) {
    verifies<req::CO_SDO_017>();
    EXPECT_EQ(send("603#4001100000000000").size(), 1U);
    send("000#0103");
    EXPECT_EQ(send("603#4001100000000000").size(), 1U);
    send("000#0203");
    EXPECT_TRUE(send("603#4001100000000000").empty());
}

}  // namespace canproof::test
