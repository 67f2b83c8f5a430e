// SPDX-License-Identifier: Apache-2.0
// Tests node 5 with object dictionaries that none of the four devices has: with absent objects, with default values
// that a client could not write, or with entries of other types. The services must answer as CiA 301 requires.
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// A minimum or maximum that does not exist: the range of the entry is open at this end.
constexpr Limit no_end{LimitKind::none, 0, 0};

constexpr Limit end_at(const std::uint32_t bits) {
    return {LimitKind::value, bits, 0};
}

class AlteredDictionary : public testing::Test, public AlteredSlaveBench {};

}  // namespace

TEST_F(AlteredDictionary, HeartbeatErrorEndsOperationalWhenErrorBehaviour1029hIsAbsent) {
    verifies<req::CO_HB_004>();
    renumber(0x1029, 0x102A);
    EXPECT_EQ(power_on(), Frames{"705#00"});
    send("605#2316100164001000");  // 1016h:1 consumer heartbeat time: node 10h, 100 ms
    send("000#0105");
    send("710#05");
    // Error code 8130h; 1001h shows the generic and the communication error; 1003h lists one error. By CiA 301,
    // 7.5.2.32, a node without 1029h enters pre-operational.
    EXPECT_EQ(pass(100), Frames{"100:085#3081110100000000"});
    EXPECT_EQ(device->node().state(), NmtState::pre_operational);
}

TEST_F(AlteredDictionary, EmcyMessagesAreSentWhenPredefinedErrorField1003hIsAbsent) {
    verifies<req::CO_EMCY_001>();
    renumber(0x1003, 0x1004);
    power_on();
    EXPECT_EQ(send("080#01"), Frames{"085#4082110000000000"});
    EXPECT_EQ(send("080#"), Frames{"085#0000000000000000"});
    EXPECT_EQ(send("605#4003100000000000"), Frames{"585#8003100000000206"});
}

TEST_F(AlteredDictionary, LongestErrorListHolds254Errors) {
    verifies<req::CO_EMCY_001>();
    extend(0x1003, 254);
    power_on();
    for (int i = 0; i < 255; ++i) {
        send("080#01");  // a SYNC of wrong length
        send("080#");
    }
    EXPECT_EQ(send("605#4003100000000000"), Frames{"585#4F031000FE000000"});
    EXPECT_EQ(send("605#400310FE00000000"), Frames{"585#430310FE40820000"});
    EXPECT_EQ(send("080#01"), Frames{"085#408211FE00000000"});
}

TEST_F(AlteredDictionary, SubIndex5OfConsumerHeartbeatTimeMonitorsNoNode) {
    verifies<req::CO_HB_002, req::CO_HB_004>();
    entry(0x1016, 4).subindex = 5;
    power_on();
    EXPECT_EQ(send("605#2316100564001000"), Frames{"585#6016100500000000"});
    send("710#05");
    EXPECT_TRUE(pass(1000).empty());
    EXPECT_EQ(send("605#2316100364001000"), Frames{"585#6016100300000000"});
    send("710#05");
    EXPECT_EQ(pass(1000), Frames{"100:085#3081110100000000"});
}

TEST_F(AlteredDictionary, SyncStartValueAbove240IsRefusedEvenWhenItsEntryHasNoLimit) {
    verifies<req::CO_PDO_024>();
    entry(0x1802, 6).limit = no_limit;
    power_on();
    EXPECT_EQ(send("605#2F021806F1000000"), Frames{"585#8002180630000906"});
    EXPECT_EQ(send("605#2F021806F0000000"), Frames{"585#6002180600000000"});
}

TEST_F(AlteredDictionary, SyncCounterOverflowAbove240IsRefusedEvenWhenItsEntryHasNoLimit) {
    verifies<req::CO_SYNC_007>();
    entry(0x1019, 0).limit = no_limit;
    power_on();
    // 1019h synchronous counter overflow value: 241, above the limit of 240
    EXPECT_EQ(send("605#2F191000F1000000"), Frames{"585#8019100030000906"});
    EXPECT_EQ(send("605#2F191000FF000000"), Frames{"585#8019100030000906"});
    EXPECT_EQ(send("605#2F191000F0000000"), Frames{"585#6019100000000000"});
    EXPECT_EQ(send("605#4019100000000000"), Frames{"585#4F191000F0000000"});
}

TEST_F(AlteredDictionary, MappingCountAboveTheNumberOfEntriesIsRefused) {
    verifies<req::CO_PDO_011>();
    entry(0x1602, 0).limit = no_limit;
    power_on();
    for (int line = 1; line <= 8; ++line) {  // maps 2000h:1 (8 bits) eight times into RPDO3, which is not valid
        send("605#230216" + std::string{"0"} + std::to_string(line) + "08010020");
    }
    EXPECT_EQ(send("605#2F02160009000000"), Frames{"585#8002160042000406"});
    EXPECT_EQ(send("605#2F02160008000000"), Frames{"585#6002160000000000"});
}

TEST_F(AlteredDictionary, ObjectsOfANinthRpdoAreOrdinaryEntriesWithoutAPdo) {
    verifies<req::CO_PDO_001, req::CO_SDO_016>();
    renumber(0x1403, 0x1408);
    renumber(0x1603, 0x1608);
    ship(0x1608, 0, 1);
    ship(0x1608, 1, 0x20000308);
    power_on();
    EXPECT_EQ(send("605#2308140105050000"), Frames{"585#6008140100000000"});
    EXPECT_EQ(send("605#4008140100000000"), Frames{"585#4308140105050000"});
    send("000#0105");
    EXPECT_TRUE(send("505#0102").empty());
    send("205#0102");
    EXPECT_EQ(send("605#4000200200000000"), Frames{"585#4F00200202000000"});
    EXPECT_EQ(send("605#4000200300000000"), Frames{"585#4F00200300000000"});
}

TEST_F(AlteredDictionary, AbsentObjectInADefaultTpdoMappingIsSentAsZeros) {
    verifies<req::CO_PDO_028, req::CO_PDO_015>();
    ship(0x1A00, 0, 3);
    ship(0x1A00, 2, 0x29990008);  // 2999h is absent
    ship(0x1A00, 3, 0x20010208);
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#000000"});
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"185#110000", "585#6001200100000000"}));
    EXPECT_EQ(send("605#2F01200222000000"), (Frames{"185#110022", "585#6001200200000000"}));
}

TEST_F(AlteredDictionary, AbsentSubIndexInADefaultTpdoMappingIsSentAsZeros) {
    verifies<req::CO_PDO_028, req::CO_PDO_015>();
    ship(0x1A00, 1, 0x20016308);  // 2001h:99 is absent
    ship(0x1A00, 2, 0x20010108);
    power_on();
    send("000#0105");
    EXPECT_EQ(send("605#2F01200111000000"), (Frames{"185#0011", "585#6001200100000000"}));
}

TEST_F(AlteredDictionary, DefaultTpdoMappingOfFewerBitsThanItsObjectCarriesTheLowBits) {
    verifies<req::CO_PDO_028>();
    ship(0x1A00, 1, 0x22070010);  // maps 16 of the 32 bits of 2207h
    ship(0x1A00, 2, 0x20010108);
    power_on();
    send("000#0105");
    EXPECT_EQ(send("605#2307220011223344"), (Frames{"185#112200", "585#6007220000000000"}));
    EXPECT_EQ(send("605#2F01200155000000"), (Frames{"185#112255", "585#6001200100000000"}));
}

TEST_F(AlteredDictionary, DefaultTpdoMappingWhoseOnlyEntryIsZeroMapsNothing) {
    verifies<req::CO_PDO_053>();
    ship(0x1A00, 0, 1);
    ship(0x1A00, 1, 0);
    power_on();
    EXPECT_TRUE(send("000#0105").empty());
}

TEST_F(AlteredDictionary, ZeroEntryInADefaultTpdoMappingTakesNoBits) {
    verifies<req::CO_PDO_028>();
    ship(0x1A00, 0, 3);
    ship(0x1A00, 2, 0);
    ship(0x1A00, 3, 0x20010208);
    power_on();
    send("000#0105");
    send("605#2F01200111000000");
    EXPECT_EQ(send("605#2F01200222000000"), (Frames{"185#1122", "585#6001200200000000"}));
}

TEST_F(AlteredDictionary, DefaultMappingLongerThanAFrameIsNotUsed) {
    verifies<req::CO_PDO_011>();
    for (const std::uint16_t mapping : {std::uint16_t{0x1600}, std::uint16_t{0x1A00}}) {
        ship(mapping, 1, 0x22060040);  // 2206h, 64 bits, twice
        ship(mapping, 2, 0x22060040);
    }
    power_on();
    EXPECT_TRUE(send("000#0105").empty());
    EXPECT_TRUE(send("205#0102030405060708").empty());
    EXPECT_TRUE(send("205#").empty()) << "not too short for no value";
    EXPECT_EQ(device->objects().read(0x2206, 0), 0U);
}

TEST_F(AlteredDictionary, DefaultMappingCount9UsesTheEightEntriesThatExist) {
    verifies<req::CO_PDO_001>();
    ship(0x1600, 0, 9);
    for (std::uint8_t line = 1; line <= 8; ++line) {
        ship(0x1600, line, 0x20000008U + line * 0x100U);
    }
    power_on();
    send("000#0105");
    send("205#1122334455667788");
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200111000000"});
    EXPECT_EQ(send("605#4000200800000000"), Frames{"585#4F00200888000000"});
}

// CiA 301, 7.5.2.36: 64 entries of one bit fill a PDO.
TEST_F(AlteredDictionary, SixtyFourMappingEntriesOfOneBitFillAPdo) {
    verifies<req::CO_PDO_001, req::CO_PDO_012>();
    extend(0x1600, 64);
    ship(0x1600, 0, 64);
    for (std::uint8_t line = 1; line < 64; ++line) {
        ship(0x1600, line, 0x00010001);  // a dummy BOOLEAN
    }
    ship(0x1600, 64, 0x20020101);  // 2002h:1
    power_on();
    send("000#0105");
    send("205#FFFFFFFFFFFFFF7F");
    EXPECT_EQ(send("605#4002200100000000"), Frames{"585#4F02200100000000"});
    send("205#0000000000000080");
    EXPECT_EQ(send("605#4002200100000000"), Frames{"585#4F02200101000000"});
}

TEST_F(AlteredDictionary, MappingEntry65DoesNotOverwriteTheNextPdo) {
    verifies<req::CO_PDO_011, req::CO_PDO_001>();
    extend(0x1600, 65);
    ship(0x1600, 0, 65);
    ship(0x1600, 1, 0x20020101);  // 2002h:1
    for (std::uint8_t line = 2; line <= 65; ++line) {
        ship(0x1600, line, 0x00010001);  // a dummy BOOLEAN
    }
    power_on();
    // A write of 1400h:5 makes the node evaluate the mapping of RPDO1 again.
    EXPECT_EQ(send("605#2B00140500000000"), Frames{"585#6000140500000000"});
    send("000#0105");
    send("205#0100000000000000");  // no effect: RPDO1 maps 65 bits, more than a PDO has
    EXPECT_EQ(send("605#4002200100000000"), Frames{"585#4F02200100000000"});
    send("305#1122334455667788");
    EXPECT_EQ(send("605#4000210100000000"), Frames{"585#4B00210111220000"});
    EXPECT_EQ(send("605#4000210400000000"), Frames{"585#4B00210477880000"});
}

TEST_F(AlteredDictionary, PdoValueRefusedByTheServiceOfItsObjectDiscardsTheWholePdo) {
    verifies<req::CO_PDO_005, req::CO_SYNC_007>();
    ship(0x1600, 1, 0x10190008);  // 1019h (SYNC counter overflow), in which 1 is reserved
    ship(0x1600, 2, 0x20000108);
    power_on();
    send("000#0105");
    send("205#0155");
    EXPECT_EQ(send("605#4019100000000000"), Frames{"585#4F19100000000000"});
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200100000000"});
    send("205#0255");
    EXPECT_EQ(send("605#4019100000000000"), Frames{"585#4F19100002000000"});
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200155000000"});
}

TEST_F(AlteredDictionary, AtMost64EntriesOfAMappingObjectAreCounted) {
    shows_rule("work is bounded");
    EXPECT_EQ(pdo_lines(description.rows.tables()), 8U);
    entry(0x1A03, 8).subindex = 64;
    EXPECT_EQ(pdo_lines(description.rows.tables()), 64U);
    entry(0x1A03, 64).subindex = 65;
    EXPECT_EQ(pdo_lines(description.rows.tables()), 64U);
}

TEST_F(AlteredDictionary, Real32MayHaveOnlyAMaximumOrOnlyAMinimum) {
    verifies<req::CO_SDO_011, req::CO_SDO_016>();
    const std::uint32_t one_and_a_half = 0x3FC00000;
    entry(0x2207, 0).type = DataType::real32;
    limit(0x2207, 0, {no_end, end_at(one_and_a_half)});
    power_on();
    EXPECT_EQ(send("605#23072200000000C0"), Frames{"585#6007220000000000"});  // 2207h = -2 is within the limits
    EXPECT_EQ(send("605#2307220000000040"), Frames{"585#8007220031000906"});  // 2207h = 2 is above the maximum
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#43072200000000C0"});
    limit(0x2207, 0, {end_at(one_and_a_half), no_end});
    power_on();
    EXPECT_EQ(send("605#2307220000000040"), Frames{"585#6007220000000000"});  // 2207h = 2 is within the limits
    EXPECT_EQ(send("605#23072200000000C0"), Frames{"585#8007220032000906"});  // 2207h = -2 is below the minimum
}

TEST_F(AlteredDictionary, ShorterOctetStringIsPaddedWithZerosToItsFixedSize) {
    verifies<req::CO_SDO_002, req::CO_SDO_059>();
    entry(0x2300, 0).type = DataType::octet_string;  // 40 bytes, default abc
    power_on();
    EXPECT_EQ(send("605#4000230000000000"), Frames{"585#4100230028000000"});
    EXPECT_EQ(send("605#2F00230041000000"), Frames{"585#6000230000000000"});
    EXPECT_EQ(send("605#4000230000000000"), Frames{"585#4100230028000000"});
    EXPECT_EQ(send("605#6000000000000000"), Frames{"585#0041000000000000"});
}

TEST_F(AlteredDictionary, ExpeditedDownloadLongerThanTheDomainIsRefused) {
    verifies<req::CO_SDO_010, req::CO_SDO_047>();
    power_on();
    device->lend(0x2400, 0, 2);
    EXPECT_EQ(send("605#2B00240001020000"), Frames{"585#6000240000000000"});
    EXPECT_EQ(send("605#2300240005060708"), Frames{"585#8000240012000706"});
    EXPECT_EQ(send("605#4000240000000000"), Frames{"585#4B00240001020000"});
}

TEST_F(AlteredDictionary, EntryWronglyAssignedToTheLssOrPdoServiceIsReadAndWrittenNormally) {
    verifies<req::CO_SDO_016>();
    for (const Service service : {Service::lss, Service::pdo}) {
        entry(0x2207, 0).service = service;
        power_on();
        EXPECT_EQ(send("605#2307220001020304"), Frames{"585#6007220000000000"});
        EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220001020304"});
    }
}

// The value of 2302h has 72 bytes; the buffer of the SDO server has 64.
TEST_F(AlteredDictionary, DownloadLongerThanTheSdoServerBufferUsesMemoryOfTheDevice) {
    verifies<req::CO_SDO_004, req::CO_SDO_043, req::CO_SDO_034>();
    power_on();
    EXPECT_EQ(send("605#2102230048000000"), Frames{"585#8002230005000405"});
    device->lend(0x2302, 0, 72);
    EXPECT_EQ(send("605#2102230048000000"), Frames{"585#6002230000000000"});
    for (int segment = 0; segment < 5; ++segment) {
        EXPECT_EQ(send("605#0041424344454647"), Frames{"585#2000000000000000"});
        EXPECT_EQ(send("605#1041424344454647"), Frames{"585#3000000000000000"});
    }
    EXPECT_EQ(send("605#0B58590000000000"), Frames{"585#2000000000000000"});  // the last segment, with two bytes
    EXPECT_EQ(send("605#4002230000000000"), Frames{"585#4102230048000000"});
    EXPECT_EQ(send("605#6000000000000000"), Frames{"585#0041424344454647"});
}

TEST_F(AlteredDictionary, SdoServerBufferAcceptsValuesUpTo64Bytes) {
    verifies<req::CO_SDO_002, req::CO_SDO_004>();
    entry(0x2302, 0).size = 64;  // 2302h is a text that begins with "A value"
    power_on();
    device->lend(0x2302, 0, 2);  // provides 2 bytes of memory; only values of more than 64 bytes would use it
    EXPECT_EQ(send("605#4002230000000000"), Frames{"585#4102230040000000"});
    ObjectDictionary& objects = device->objects();
    objects.put(objects.lookup(0x2302, 0), ByteView{});
    EXPECT_EQ(send("605#6000000000000000"), Frames{"585#00412076616C7565"});  // the answer still has the value from the
                                                                              // start of the upload: "A value"
    EXPECT_EQ(send("605#2102230040000000"), Frames{"585#6002230000000000"});
}

TEST_F(AlteredDictionary, BlockDownloadThatFillsItsMemoryMayEndWithAnEmptySegment) {
    verifies<req::CO_SDO_050, req::CO_SDO_029, req::CO_SDO_052>();
    power_on();
    device->lend(0x2400, 0, 14);
    EXPECT_EQ(send("605#C000240000000000"), Frames{"585#A40024007F000000"});
    EXPECT_TRUE(send("605#0101020304050607").empty());
    EXPECT_TRUE(send("605#0208090A0B0C0D0E").empty());
    EXPECT_EQ(send("605#8300000000000000"), Frames{"585#A2037F0000000000"});
    // End of the block download: C1h | 7 unused bytes << 2.
    EXPECT_EQ(send("605#DD00000000000000"), Frames{"585#A100000000000000"});
    EXPECT_EQ(send("605#4000240000000000"), Frames{"585#410024000E000000"});
    EXPECT_EQ(send("605#6000000000000000"), Frames{"585#0001020304050607"});
    EXPECT_EQ(send("605#7000000000000000"), Frames{"585#1108090A0B0C0D0E"});
}

TEST_F(AlteredDictionary, ChangeOfAnUnmappedEntryWhoseHashEqualsThatOfAMappedEntryTriggersNoTpdo) {
    verifies<req::CO_PDO_015>();
    ASSERT_EQ(watch_mark(0x2001, 3), watch_mark(0x2003, 1));
    ship(0x1A00, 0, 1);
    ship(0x1A00, 1, 0x20010308);
    power_on();
    EXPECT_EQ(send("000#0105"), Frames{"185#00"});
    EXPECT_EQ(send("605#2F03200101000000"), Frames{"585#6003200100000000"});
    EXPECT_EQ(send("605#2F01200311000000"), (Frames{"185#11", "585#6001200300000000"}));
}

TEST_F(AlteredDictionary, DownloadThatFitsTheSdoServerBufferNeedsNoMemoryOfTheDevice) {
    verifies<req::CO_SDO_004, req::CO_SDO_043>();
    power_on();
    device->lend(0x2207, 0, 2);
    EXPECT_EQ(send("605#2107220004000000"), Frames{"585#6007220000000000"});
    EXPECT_EQ(send("605#0711223344000000"), Frames{"585#2000000000000000"});
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220011223344"});
}

TEST_F(AlteredDictionary, ResetCommunicationKeepsTheValueOfTheFirstManufacturerEntry) {
    verifies<req::CO_NMT_006>();
    EntryRow& first = entry(0x2000, 0);  // 2000h:0 becomes an ordinary value with default 0
    first.rights = rights::read | rights::write;
    first.offset = static_cast<std::uint16_t>(description.rows.layout.image.size());
    description.rows.layout.image.push_back(0);
    power_on();
    EXPECT_EQ(send("605#2F00200007000000"), Frames{"585#6000200000000000"});
    EXPECT_EQ(send("000#8205"), Frames{"705#00"});
    EXPECT_EQ(send("605#4000200000000000"), Frames{"585#4F00200007000000"});
}

TEST_F(AlteredDictionary, StoreSignatureReceivedInAPdoStoresNothing) {
    verifies<req::CO_STORE_001>();
    entry(0x2207, 0).service = Service::store;
    ship(0x1600, 0, 1);
    ship(0x1600, 1, 0x22070020);
    power_on();
    send("605#2F00200111000000");
    send("000#0105");
    EXPECT_TRUE(send("205#73617665").empty());  // "save"
    power_on();
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200100000000"});
}

TEST_F(AlteredDictionary, SubIndex5OfStoreParameters1010hStoresTheManufacturerParameters) {
    verifies<req::CO_STORE_001>();
    entry(0x1010, 4).subindex = 5;
    entry(0x1010, 3).subindex = 4;  // 1010h:3 and 1010h:4 become 1010h:4 and 1010h:5
    power_on();
    send("605#2F00200111000000");
    EXPECT_EQ(send("605#2310100573617665"), Frames{"585#6010100500000000"});
    power_on();
    EXPECT_EQ(send("605#4000200100000000"), Frames{"585#4F00200111000000"});
}

}  // namespace canproof::test
