// SPDX-License-Identifier: Apache-2.0
// Tests the SDO server with expedited and segmented transfers (CiA 301, 7.2.4). The tests use a CAN-CBX-AO412 as node 3
// and the conformance slave as node 5.
#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

using Sdo = CbxTest;

class SlaveSdo : public testing::Test, public SlaveBench {};

TEST_F(Sdo, ExpeditedUploadShowsItsLength) {
    verifies<req::CO_SDO_001, req::CO_K_SDO_REQUEST_ID, req::CO_K_SDO_RESPONSE_ID>();
    EXPECT_EQ(send("603#4001100000000000"), (Frames{"583#4F01100000000000"}));  // the value has one byte
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));  // the value has two bytes
    EXPECT_EQ(send("603#4000100000000000"), (Frames{"583#4300100091010800"}));  // the value has four bytes
}

TEST_F(Sdo, SegmentedUploadReturnsTheDeviceName) {
    verifies<req::CO_SDO_002, req::CO_SDO_055>();
    // "CAN-CBX-AO412" has 13 bytes: segments of 7 and 6 bytes
    EXPECT_EQ(send("603#4008100000000000"), (Frames{"583#410810000D000000"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#0043414E2D434258"}));  // the first segment: `CAN-CBX`
    // the last segment: `-AO412` and one unused byte
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#132D414F34313200"}));
}

TEST_F(Sdo, ExpeditedDownloadWithAndWithoutSizeIsAccepted) {
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

TEST_F(Sdo, UploadRequestIs40hAndAbortIs80h) {
    verifies<req::CO_SDO_042, req::CO_SDO_063>();
    EXPECT_EQ(send("603#4001100000000000"), (Frames{"583#4F01100000000000"}));
    EXPECT_EQ(send("603#4010200000000000"), (Frames{"583#8010200000000206"}));
}

TEST_F(Sdo, NumbersAreSentLeastSignificantByteFirst) {
    verifies<req::CO_SDO_041>();
    EXPECT_EQ(send("603#2320100178563412"), (Frames{"583#6020100100000000"}));  // 1020h:1 = 12345678h
    EXPECT_EQ(device->objects().read(0x1020, 1), 0x12345678U);
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100178563412"}));
    EXPECT_EQ(send("603#4010200100000000"), (Frames{"583#8010200100000206"}));  // 2010h is absent: 06020000h
    EXPECT_EQ(send("603#4008100000000000"), (Frames{"583#410810000D000000"}));  // a segmented upload of 13 bytes begins
}

TEST_F(Sdo, SegmentedDownloadSetsTheValueWithItsLastSegment) {
    verifies<req::CO_SDO_004, req::CO_SDO_043>();
    EXPECT_EQ(send("603#2120100104000000"), (Frames{"583#6020100100000000"}));
    // the segment has two bytes of data and five unused: byte 0 = 0 | 5 << 1
    EXPECT_EQ(send("603#0A34120000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_EQ(device->objects().read(0x1020, 1), 0U);  // the value is not set before the last segment
    // Byte 0 has the toggle bit, five unused bytes, and the mark of the last segment.
    EXPECT_EQ(send("603#1B78560000000000"), (Frames{"583#3000000000000000"}));
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100134127856"}));
}

TEST_F(Sdo, SegmentedDownloadWithoutSizeIsAccepted) {
    verifies<req::CO_SDO_004, req::CO_SDO_043>();
    EXPECT_EQ(send("603#2017100000000000"), (Frames{"583#6017100000000000"}));
    EXPECT_EQ(send("603#0BE8030000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B171000E8030000"}));
}

TEST_F(Sdo, ToggleBitMustAlternate) {
    verifies<req::CO_SDO_005, req::CO_E_ABORT>();
    send("603#4008100000000000");
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#8008100000000305"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));  // the abort has ended the transfer
    send("603#2120100104000000");
    EXPECT_EQ(send("603#1A34120000000000"), (Frames{"583#8020100100000305"}));
}

TEST_F(Sdo, UnknownSpecifiersAndUnexpectedSegmentsAreAborted) {
    verifies<req::CO_SDO_006, req::CO_E_ABORT, req::CO_SDO_056>();
    EXPECT_EQ(send("603#E000100000000000"), (Frames{"583#8000100001000405"}));
    EXPECT_EQ(send("603#A000100000000000"), (Frames{"583#8000100001000405"}));  // this device offers no block upload
    EXPECT_EQ(send("603#C200100000000000"), (Frames{"583#8000100001000405"}));  // this device offers no block download
    EXPECT_EQ(send("603#0011223344556677"), (Frames{"583#8000000001000405"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));
    send("603#4008100000000000");
    EXPECT_EQ(send("603#0011223344556677"), (Frames{"583#8008100001000405"}));  // download segment during an upload
}

TEST_F(Sdo, FramesOfOtherThanEightBytesAreIgnored) {
    verifies<req::CO_SDO_007>();
    EXPECT_TRUE(send("603#40001000000000").empty());
    EXPECT_TRUE(send("603#2B171000E803").empty());
    EXPECT_TRUE(send("603#").empty());
    EXPECT_TRUE(send("603#R8").empty());
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));
}

TEST_F(Sdo, AbsentObjectsAndSubIndicesAreRefused) {
    verifies<req::CO_SDO_008, req::CO_E_ABORT, req::CO_SDO_057>();
    EXPECT_EQ(send("603#4034120000000000"), (Frames{"583#8034120000000206"}));
    EXPECT_EQ(send("603#2B34120000000000"), (Frames{"583#8034120000000206"}));
    EXPECT_EQ(send("603#4011640500000000"), (Frames{"583#8011640511000906"}));
    EXPECT_EQ(send("603#4000100100000000"), (Frames{"583#8000100111000906"}));
    EXPECT_EQ(send("603#2117400002000000"), (Frames{"583#8017400000000206"}));
}

TEST_F(Sdo, ReadOnlyEntriesCannotBeWritten) {
    verifies<req::CO_SDO_009, req::CO_E_ABORT>();
    EXPECT_EQ(send("603#2300100000000000"), (Frames{"583#8000100002000106"}));
    EXPECT_EQ(send("603#2F11640004000000"), (Frames{"583#8011640002000106"}));  // 6411h:0 is read-only
    EXPECT_EQ(send("603#210810000D000000"), (Frames{"583#8008100002000106"}));
}

TEST_F(Sdo, DownloadsOfWrongLengthAreRefused) {
    verifies<req::CO_SDO_010, req::CO_SDO_011, req::CO_E_ABORT, req::CO_SDO_059, req::CO_SDO_060>();
    EXPECT_EQ(send("603#2317100001000000"), (Frames{"583#8017100012000706"}));  // four bytes for an entry of two
    // 1017h producer heartbeat time: one byte instead of two
    EXPECT_EQ(send("603#2F17100001000000"), (Frames{"583#8017100013000706"}));
    // the announced size is three bytes instead of two
    EXPECT_EQ(send("603#2117100003000000"), (Frames{"583#8017100012000706"}));
    send("603#2117100001000000");  // announces one byte, but sends two
    EXPECT_EQ(send("603#0BE8030000000000"), (Frames{"583#8017100010000706"}));
    send("603#2017100000000000");
    EXPECT_EQ(send("603#01E8030000000000"), (Frames{"583#8017100012000706"}));  // seven bytes for an entry of two
    EXPECT_EQ(send("603#4017100000000000"), (Frames{"583#4B17100000000000"}));
}

TEST_F(Sdo, NewInitiateEndsTheRunningTransfer) {
    verifies<req::CO_SDO_012>();
    send("603#2120100104000000");
    send("603#0A34120000000000");
    EXPECT_EQ(send("603#4000100000000000"), (Frames{"583#4300100091010800"}));
    EXPECT_EQ(send("603#1B78560000000000"), (Frames{"583#8000000001000405"}));
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100100000000"}));
}

TEST_F(Sdo, ClientAbortEndsTheTransferAndIsNotAnswered) {
    verifies<req::CO_SDO_013>();
    send("603#4008100000000000");
    EXPECT_TRUE(send("603#8008100000000405").empty());
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#8000000001000405"}));
}

TEST_F(Sdo, StalledTransferIsAbortedAfterOneSecond) {
    verifies<req::CO_SDO_014, req::CO_K_SDO_TIMEOUT>();
    send("603#4008100000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:583#8008100000000405"}));
    EXPECT_TRUE(pass(5000).empty());
}

TEST_F(Sdo, BusOffEndsATransferAndTheWarningLimitDoesNot) {
    verifies<req::CO_SDO_055, req::CO_SDO_056>();
    send("603#4008100000000000");
    inputs.can_state = 1;
    EXPECT_TRUE(set_inputs().empty());
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#0043414E2D434258"}));
    inputs.can_state = 3;
    set_inputs();
    inputs.can_state = 0;
    set_inputs();
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#8000000001000405"}));  // the bus-off has ended the transfer
}

TEST_F(Sdo, EachDownloadSegmentRestartsTheTimeOut) {
    verifies<req::CO_SDO_014, req::CO_K_SDO_TIMEOUT>();
    send("603#2120100104000000");  // announces four bytes; each segment carries one
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(send("603#0C78000000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(send("603#1C56000000000000"), (Frames{"583#3000000000000000"}));
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(send("603#0C34000000000000"), (Frames{"583#2000000000000000"}));
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:583#8020100100000405"}));
    EXPECT_EQ(send("603#4020100100000000"), (Frames{"583#4320100100000000"}));  // nothing was written
}

TEST_F(Sdo, RefusedWriteChangesNothing) {
    verifies<req::CO_SDO_011>();
    EXPECT_EQ(send("603#2F43640103000000"), (Frames{"583#8043640130000906"}));
    EXPECT_EQ(send("603#4043640100000000"), (Frames{"583#4F43640101000000"}));
}

TEST_F(Sdo, TransferContinuesWhenTheNodeIsStarted) {
    verifies<req::CO_SDO_002, req::CO_SDO_017, req::CO_SDO_055>();
    EXPECT_EQ(send("603#4008100000000000"), (Frames{"583#410810000D000000"}));
    send("000#0103");
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#0043414E2D434258"}));
    send("000#8003");
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#132D414F34313200"}));
}

TEST_F(Sdo, SdoIsServedInPreOperationalAndOperationalOnly) {
    verifies<req::CO_SDO_017, req::CO_SDO_045>();
    EXPECT_EQ(send("603#4001100000000000").size(), 1U);
    send("000#0103");
    EXPECT_EQ(send("603#4001100000000000").size(), 1U);
    send("000#0203");
    EXPECT_TRUE(send("603#4001100000000000").empty());
}

TEST_F(SlaveSdo, AbortNamesTheObjectOfTheRefusedRequestOrEndedTransfer) {
    verifies<req::CO_SDO_018>();
    talk(*this, {
                    // The abort contains the object of the refused initiate.
                    {"605#403412AB00000000", {"585#803412AB00000206"}},
                    {"605#4008100000000000", {"585#4108100011000000"}},
                    // The abort contains the object of the ended transfer.
                    {"605#7000000000000000", {"585#8008100000000305"}},
                    {"605#7000000000000000", {"585#8000000001000405"}},  // no transfer is open
                    {"605#00AAAAAAAAAAAAAA", {"585#8000000001000405"}},  // bytes 1 to 3 of a segment are data
                    {"605#2100230005000000", {"585#6000230000000000"}},
                    {"605#6000000000000000", {"585#8000230001000405"}},
                });
}

TEST_F(SlaveSdo, EachUploadSegmentRestartsTheTimeOut) {
    verifies<req::CO_SDO_014, req::CO_K_SDO_TIMEOUT>();
    // 1008h has 17 bytes: the third segment is the last
    EXPECT_EQ(send("605#4008100000000000"), (Frames{"585#4108100011000000"}));
    for (const char* request : {"605#6000000000000000", "605#7000000000000000"}) {
        EXPECT_TRUE(pass(999).empty()) << request;
        EXPECT_EQ(send(request).size(), 1U);
    }
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:585#8008100000000405"}));
}

TEST_F(SlaveSdo, UploadOfAnEmptyStringIsOneSegmentWithoutData) {
    verifies<req::CO_SDO_019>();
    talk(*this, {
                    {"605#4000230000000000", {"585#4700230061626300"}},  // "abc"
                    {"605#2100230000000000", {"585#6000230000000000"}},
                    {"605#0F00000000000000", {"585#2000000000000000"}},  // seven unused bytes, last segment
                    {"605#4000230000000000", {"585#4100230000000000"}},
                    {"605#6000000000000000", {"585#0F00000000000000"}},
                    {"605#6000000000000000", {"585#8000000001000405"}},
                });
}

TEST_F(SlaveSdo, DomainWithMemoryOfOneByteAcceptsOneByteAndNoMore) {
    verifies<req::CO_SDO_033>();
    device = std::make_unique<host::GenericDevice>(slave(), memory, queue);
    device->lend(program_index, 0, 1);
    EXPECT_EQ(switch_on([this] { device->power_on(node_id, now); }), (Frames{"705#00"}));
    EXPECT_EQ(send("605#2100240001000000"), (Frames{"585#6000240000000000"}));
    EXPECT_EQ(send("605#0D2A000000000000"), (Frames{"585#2000000000000000"}));
    EXPECT_EQ(send("605#4000240000000000"), (Frames{"585#4F0024002A000000"}));
    EXPECT_EQ(send("605#2100240002000000"), (Frames{"585#8000240012000706"}));
}

TEST_F(SlaveSdo, DownloadWithAnnouncedSize0IsAbortedWhenAByteArrives) {
    verifies<req::CO_SDO_060>();
    talk(*this, {
                    {"605#2100230000000000", {"585#6000230000000000"}},
                    {"605#0D78000000000000", {"585#8000230010000706"}},  // one byte, although size 0 was announced
                    {"605#4000230000000000", {"585#4700230061626300"}},
                });
}

TEST_F(SlaveSdo, SizeFieldWithoutSizeIndicatorIsIgnored) {
    verifies<req::CO_SDO_003, req::CO_SDO_060>();
    talk(*this, {
                    // bytes 4 to 7 are no size, because the size bit is 0
                    {"605#20002300FFFFFFFF", {"585#6000230000000000"}},
                    {"605#0D78000000000000", {"585#2000000000000000"}},  // "x", last
                    {"605#4000230000000000", {"585#4F00230078000000"}},
                });
}

TEST_F(SlaveSdo, ThreeBytesAreTransferredExpedited) {
    verifies<req::CO_SDO_001, req::CO_SDO_003>();
    talk(*this, {
                    {"605#4000230000000000", {"585#4700230061626300"}},  // 2300h = "abc"
                    {"605#2700230078797AFF", {"585#6000230000000000"}},  // the fourth byte is unused
                    {"605#4000230000000000", {"585#4700230078797A00"}},  // "xyz"
                });
}

TEST_F(SlaveSdo, DownloadWithoutSizeHasTheLengthOfItsEntry) {
    verifies<req::CO_SDO_003>();
    talk(*this, {
                    {"605#2201210134120000", {"585#6001210100000000"}},  // 2101h:1 has 16 bits; 2101h:0 has 8
                    {"605#4001210100000000", {"585#4B01210134120000"}},
                });
}

TEST_F(SlaveSdo, StringMayBeShorterThanItsCapacityButNotLonger) {
    verifies<req::CO_SDO_010, req::CO_SDO_016, req::CO_SDO_059>();
    talk(*this, {
                    {"605#2F00230078000000", {"585#6000230000000000"}},  // "x"
                    {"605#4000230000000000", {"585#4F00230078000000"}},
                    {"605#2100230028000000", {"585#6000230000000000"}},  // 40 bytes fit
                    {"605#8000230000000008", {}},
                    {"605#2100230029000000", {"585#8000230012000706"}},  // 41 bytes do not fit into 2300h
                    {"605#2000230000000000", {"585#6000230000000000"}},
                    {"605#0061616161616161", {"585#2000000000000000"}},
                    {"605#1061616161616161", {"585#3000000000000000"}},
                    {"605#0061616161616161", {"585#2000000000000000"}},
                    {"605#1061616161616161", {"585#3000000000000000"}},
                    {"605#0061616161616161", {"585#2000000000000000"}},  // 35 bytes so far
                    {"605#1361616161616100", {"585#8000230012000706"}},  // six more bytes
                    {"605#4000230000000000", {"585#4F00230078000000"}},
                });
}

TEST_F(SlaveSdo, ValueOfEightBytesIsTransferredInSegments) {
    verifies<req::CO_SDO_002, req::CO_SDO_004, req::CO_SDO_043, req::CO_SDO_016, req::CO_SDO_055>();
    talk(*this, {
                    {"605#2106220008000000", {"585#6006220000000000"}},
                    {"605#0001020304050607", {"585#2000000000000000"}},
                    {"605#1D08000000000000", {"585#3000000000000000"}},
                    {"605#4006220000000000", {"585#4106220008000000"}},
                    {"605#6000000000000000", {"585#0001020304050607"}},
                    {"605#7000000000000000", {"585#1D08000000000000"}},
                    {"605#2306220001020304", {"585#8006220013000706"}},  // four bytes for an entry of eight
                    {"605#2206220001020304", {"585#8006220013000706"}},
                    {"605#4006220000000000", {"585#4106220008000000"}},
                    {"605#6000000000000000", {"585#0001020304050607"}},
                });
}

TEST_F(SlaveSdo, SegmentsWithoutATransferStoreNothing) {
    verifies<req::CO_SDO_011, req::CO_SDO_056>();
    // 300 segments are more than fit into the buffer of the SDO server
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(send("605#0041414141414141"), (Frames{"585#8000000001000405"}));
    }
    // a segment after the end of a transfer stores nothing either
    talk(*this, {
                    {"605#2100230002000000", {"585#6000230000000000"}},
                    {"605#0B68690000000000", {"585#2000000000000000"}},
                    {"605#1B68690000000000", {"585#8000000001000405"}},
                    {"605#0041414141414141", {"585#8000000001000405"}},
                    {"605#4000230000000000", {"585#4B00230068690000"}},
                });
}

TEST_F(SlaveSdo, DownloadSegmentDuringAnUploadIsAbortedAndStoresNothing) {
    verifies<req::CO_SDO_011, req::CO_SDO_056>();
    talk(*this, {
                    {"605#4001230000000000", {"585#4101230036000000"}},  // 54 bytes, const
                    {"605#0041414141414141", {"585#8001230001000405"}},
                    {"605#4001230000000000", {"585#4101230036000000"}},
                    {"605#6000000000000000", {"585#0054686520717569"}},  // "The qui"
                });
}

TEST_F(SlaveSdo, ShortFrameIsNotCompletedFromThePreviousFrame) {
    verifies<req::CO_SDO_007>();
    talk(*this, {
                    {"605#2F01220008000000", {"585#6001220000000000"}},
                    {"605#2F012200", {}},
                    {"605#2F01220002", {}},
                    {"605#4001220000000000", {"585#4F01220008000000"}},
                    {"605#40", {}},
                    {"605#40012200000000", {}},
                    {"605#2100230002000000", {"585#6000230000000000"}},
                    {"605#0B6869", {}},  // the transfer continues
                    {"605#0B68690000000000", {"585#2000000000000000"}},
                });
}

TEST_F(SlaveSdo, UnusedBitsOfARequestAreIgnored) {
    verifies<req::CO_SDO_035>();
    talk(*this, {
                    {"605#5F00100000000000", {"585#4300100078563412"}},  // 40h with its five unused bits set
                    {"605#40001000FFFFFFFF", {"585#4300100078563412"}},
                    {"605#3F01220008000000", {"585#6001220000000000"}},  // command 2Fh with bit 4 set
                    {"605#2F0122000299AA55", {"585#6001220000000000"}},  // the bytes after the value are not 0
                    {"605#4001220000000000", {"585#4F01220002000000"}},
                    {"605#4008100000000000", {"585#4108100011000000"}},
                    {"605#6FFFFFFFFFFFFFFF", {"585#00436F6E666F726D"}},
                    {"605#9F08100000000000", {}},  // abort (80h) with its five unused bits set
                    {"605#7000000000000000", {"585#8000000001000405"}},
                });
}

TEST_F(SlaveSdo, RequestsToOtherNodesAndOfOtherFormatsAreIgnored) {
    verifies<req::CO_FRAME_001>();
    talk(*this, {
                    {"604#4000100000000000", {}},
                    {"606#4000100000000000", {}},
                    {"600#4000100000000000", {}},
                    {"585#4000100000000000", {}},
                    {"00000605#4000100000000000", {}},
                    {"605#R8", {}},
                });
}

}  // namespace canproof::test
