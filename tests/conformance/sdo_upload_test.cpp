// SPDX-License-Identifier: Apache-2.0
// Tests uploads of numbers of one to four bytes, which the node reads with one access to memory. The numbers lie next
// to other values, at the end of the memory or behind a gap of sub-indices. Some requests come during a transfer, or
// when a service is due. The tests use the conformance slave as node 5.
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class SdoUpload : public testing::Test, public SlaveBench {};

class SdoUploadOfAltered : public testing::Test, public AlteredSlaveBench {};

}  // namespace

TEST_F(SdoUpload, NumberIsSentWithoutItsNeighboursInMemory) {
    verifies<req::CO_SDO_001, req::CO_SDO_041>();
    talk(*this, {
                    {"605#2F002001FF000000", {"585#6000200100000000"}},  // 2000h has eight numbers of one byte
                    {"605#2F002002A5000000", {"585#6000200200000000"}},
                    {"605#2F002003FF000000", {"585#6000200300000000"}},
                    {"605#4000200200000000", {"585#4F002002A5000000"}},
                    {"605#2F002002FF000000", {"585#6000200200000000"}},
                    {"605#2F00200100000000", {"585#6000200100000000"}},
                    {"605#4000200100000000", {"585#4F00200100000000"}},
                    {"605#2B002101FFFF0000", {"585#6000210100000000"}},  // 2100h has four numbers of two bytes
                    {"605#2B002102C3A50000", {"585#6000210200000000"}},
                    {"605#2B002103FFFF0000", {"585#6000210300000000"}},
                    {"605#4000210200000000", {"585#4B002102C3A50000"}},
                    {"605#2F02200101000000", {"585#6002200100000000"}},  // 2002h has eight BOOLEANs
                    {"605#2F02200301000000", {"585#6002200300000000"}},
                    {"605#4002200200000000", {"585#4F02200200000000"}},
                    {"605#4002200300000000", {"585#4F02200301000000"}},
                    {"605#2307220078563412", {"585#6007220000000000"}},
                    {"605#4007220000000000", {"585#4307220078563412"}},
                    {"605#4002220000000000", {"585#430222000000C03F"}},  // REAL32 1.5 = 3FC00000h
                });
}

TEST_F(SdoUploadOfAltered, NumberInTheLastBytesOfTheMemoryIsSent) {
    verifies<req::CO_SDO_001>();
    extend(0x2000, 9);  // the memory ends with 2000h:9, which has one byte
    power_on();
    EXPECT_EQ(send("605#2F002009A5000000"), Frames{"585#6000200900000000"});
    EXPECT_EQ(send("605#4000200900000000"), Frames{"585#4F002009A5000000"});
    extend(0x2100, 5);  // the memory ends with 2100h:5, which has two bytes
    power_on();
    EXPECT_EQ(send("605#2B002105C3A50000"), Frames{"585#6000210500000000"});
    EXPECT_EQ(send("605#4000210500000000"), Frames{"585#4B002105C3A50000"});
    extend(0x2000, 11);  // 2000h:9 is now followed by four bytes: 2100h:5, 2000h:10 and 2000h:11
    power_on();
    EXPECT_EQ(send("605#2F00200B78000000"), Frames{"585#6000200B00000000"});
    EXPECT_EQ(send("605#2F002009A5000000"), Frames{"585#6000200900000000"});
    EXPECT_EQ(send("605#4000200900000000"), Frames{"585#4F002009A5000000"});
}

TEST_F(SdoUpload, EntryBehindAGapOfSubIndicesIsSent) {
    verifies<req::CO_SDO_001, req::CO_SDO_057, req::CO_SDO_058>();
    talk(*this, {
                    {"605#2B00180564000000", {"585#6000180500000000"}},  // 1800h:5 event timer of 100 ms
                    {"605#4000180500000000", {"585#4B00180564000000"}},
                    {"605#4000180400000000", {"585#8000180411000906"}},  // 1800h has no sub-index 4
                    {"605#4000180700000000", {"585#8000180711000906"}},
                    {"605#4000FF0000000000", {"585#8000FF0000000206"}},
                    {"605#4005220000000000", {"585#8005220001000106"}},  // 2205h is write-only
                });
}

/// In the table of entries, the rows of 2101h follow the five rows of 2100h. The row that lies nine rows behind the
/// first one of 2100h has sub-index 9, but it belongs to 2101h.
TEST_F(SdoUploadOfAltered, AbsentSubIndexIsNotTakenFromAnotherRow) {
    verifies<req::CO_SDO_057>();
    entry(0x2101, 4).subindex = 9;
    entry(0x2101, 3).rights = rights::read | rights::write;  // 3 as a number
    entry(0x2101, 3).subindex = 5;
    power_on();
    EXPECT_EQ(send("605#4000210900000000"), Frames{"585#8000210911000906"});
    EXPECT_EQ(send("605#4001210900000000"), Frames{"585#4B01210900000000"});
    EXPECT_EQ(send("605#4001210300000000"), Frames{"585#8001210311000906"});
    EXPECT_EQ(send("605#4001210500000000"), Frames{"585#4B01210500000000"});
}

TEST_F(SdoUpload, NumberDuringADownloadInSegmentsEndsThatDownloadAndItsTimeOut) {
    verifies<req::CO_SDO_012, req::CO_SDO_014>();
    talk(*this, {
                    {"605#2100230003000000", {"585#6000230000000000"}},
                    {"605#4001220000000000", {"585#4F01220002000000"}},
                });
    EXPECT_TRUE(pass(2000).empty());
    EXPECT_EQ(send("605#0978797A00000000"), Frames{"585#8000000001000405"});  // no transfer is open
}

/// The device is called late: an SDO time-out and a missing heartbeat are due when the request comes.
TEST_F(SdoUpload, WhatIsDueHappensBeforeTheAnswer) {
    verifies<req::CO_SDO_014, req::CO_EMCY_001>();
    send("605#4008100000000000");
    now = now + milliseconds(1000);
    EXPECT_EQ(send("605#4001220000000000"), (Frames{"585#8008100000000405", "585#4F01220002000000"}));
    send("605#2316100164001000");  // 1016h:1 consumer heartbeat time: node 10h, 100 ms
    send("710#05");
    now = now + milliseconds(100);
    // Error code 8130h. 1003h:0 shows one error.
    EXPECT_EQ(send("605#4003100000000000"), (Frames{"085#3081110100000000", "585#4F03100001000000"}));
}

TEST_F(SdoUpload, RequestOfAnotherLengthOrFormatIsNotAnswered) {
    verifies<req::CO_SDO_007, req::CO_SDO_015>();
    EXPECT_EQ(send("605#4001220000000000"), Frames{"585#4F01220002000000"});
    for (const char* request : {"605#40012200000000", "605#40012200", "605#", "605#R8", "00000605#4001220000000000",
                                "604#4001220000000000", "606#4001220000000000"}) {
        EXPECT_TRUE(send(request).empty()) << request;
    }
}

TEST_F(SdoUpload, NumberIsSentOnlyWhileSdoWorks) {
    verifies<req::CO_SDO_017, req::CO_SDO_015>();
    send("000#0105");
    EXPECT_EQ(send("605#4001220000000000"), Frames{"585#4F01220002000000"});
    send("000#0205");  // stopped
    EXPECT_TRUE(send("605#4001220000000000").empty());
    send("000#8005");
    EXPECT_EQ(send("605#4001220000000000"), Frames{"585#4F01220002000000"});
    node_id = 6;
    power_on();
    EXPECT_TRUE(send("605#4001220000000000").empty());
    EXPECT_EQ(send("606#4001220000000000"), Frames{"586#4F01220002000000"});
}

}  // namespace canproof::test
