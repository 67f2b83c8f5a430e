// SPDX-License-Identifier: Apache-2.0
// Tests SDO block download (CiA 301, 7.2.4.3.8 to 7.2.4.3.11) with complete exchanges of frames. Also tests a device
// without block transfer.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/sdo_block_cases.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(SdoBlock, DownloadOfNineBytesStoresThem) {
    verifies<req::CO_SDO_026, req::CO_SDO_050, req::CO_SDO_029, req::CO_SDO_052, req::CO_SDO_033>();
    hold({0xAA});
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                });
    EXPECT_EQ(held(), Bytes{0xAA});  // the value is not set before the end of the download
    talk(*this, {
                    // C1h + 5 unused bytes << 2 = D5h; the CRC is 31C3h
                    {"605#D5C3310000000000", {"585#A100000000000000"}},
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, DownloadWithoutSizeIsAccepted) {
    verifies<req::CO_SDO_029, req::CO_SDO_052>();
    talk(*this, {
                    {"605#C400240000000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5C3310000000000", {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), nine);
}

/// 2100h:1 is an INTEGER16, 2000h:1 an UNSIGNED8. The first download announces two bytes; the next one, to 2000h:1,
/// announces no size and has one byte.
TEST_F(SdoBlock, AnnouncedSizeAppliesToItsOwnDownloadOnly) {
    verifies<req::CO_SDO_060>();
    using Transfer = std::vector<Exchange>;
    const std::vector<Transfer> with_size{
        {{"605#2100210102000000", {"585#6000210100000000"}}, {"605#0B34120000000000", {"585#2000000000000000"}}},
        {{"605#C200210102000000", {"585#A40021017F000000"}},
         {"605#8134120000000000", {"585#A2017F0000000000"}},
         {"605#D500000000000000", {"585#A100000000000000"}}}};
    const std::vector<Transfer> without_size{
        {{"605#2000200100000000", {"585#6000200100000000"}}, {"605#0D55000000000000", {"585#2000000000000000"}}},
        {{"605#C000200100000000", {"585#A40020017F000000"}},
         {"605#8155000000000000", {"585#A2017F0000000000"}},
         {"605#D900000000000000", {"585#A100000000000000"}}}};
    for (const Transfer& first : with_size) {
        for (const Transfer& next : without_size) {
            talk(*this, first);
            talk(*this, next);
            talk(*this, {{"605#4000200100000000", {"585#4F00200155000000"}},
                         {"605#2F00200100000000", {"585#6000200100000000"}}});
        }
    }
}

TEST_F(SdoBlock, ReceivedCrcIsNotCheckedWhenTheClientDoesNotSupportCrc) {
    verifies<req::CO_SDO_051>();
    talk(*this, {
                    {"605#C200240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5FFFF0000000000", {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, WrongCrcRefusesTheWholeDownload) {
    verifies<req::CO_SDO_028, req::CO_SDO_047, req::CO_E_ABORT>();
    hold({1, 2, 3});
    for (const std::string end : {"605#D5C2310000000000", "605#D5C3300000000000", "605#D531C30000000000"}) {
        talk(*this, {
                        {"605#C600240009000000", {"585#A40024007F000000"}},
                        {"605#0131323334353637", {}},
                        {"605#8238390000000000", {"585#A2027F0000000000"}},
                        {end, {"585#8000240004000405"}},
                        {"605#D5C3310000000000", {stray}},
                    });
    }
    EXPECT_EQ(held(), (Bytes{1, 2, 3}));
}

TEST_F(SdoBlock, LostDownloadSegmentsAreRequestedAgain) {
    verifies<req::CO_SDO_026, req::CO_SDO_050>();
    const Bytes bytes = counting(28);
    const std::string crc = block_end("605", bytes);
    talk(*this, {
                    {"605#C60024001C000000", {"585#A40024007F000000"}},
                    {"605#0101020304050607", {}},
                    {"605#030F101112131415", {}},  // segment 3 without segment 2, which was lost
                    {"605#84161718191A1B1C", {"585#A2017F0000000000"}},
                    {"605#0108090A0B0C0D0E", {}},                        // after the acknowledgement, the missing
                                                                         // segment is repeated as segment 1
                    {"605#83161718191A1B1C", {"585#A2017F0000000000"}},  // segment 3 again without segment 2
                    // segment 2 arrives without segment 1, which is lost too
                    {"605#82161718191A1B1C", {"585#A2007F0000000000"}},
                    {"605#010F101112131415", {}},
                    {"605#82161718191A1B1C", {"585#A2027F0000000000"}},
                    {crc, {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), bytes);
}

TEST_F(SdoBlock, SegmentReceivedTwiceCountsOnce) {
    verifies<req::CO_SDO_026>();
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5C3310000000000", {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, FullSubBlockIsAcknowledgedAtItsEnd) {
    verifies<req::CO_SDO_050, req::CO_K_SDO_BLOCK_SIZE>();
    const Bytes bytes = counting(7 * 127 + 5, 3);
    send("605#C60024007E030000");  // the size is 894 = 37Eh bytes
    for (unsigned sequence = 1; sequence < 127; ++sequence) {
        ASSERT_TRUE(send(block_segment("605", sequence, bytes, (sequence - 1) * std::size_t{7})).empty());
    }
    EXPECT_EQ(send(block_segment("605", 127, bytes, 126 * 7)), (Frames{"585#A27F7F0000000000"}));
    EXPECT_EQ(send(block_segment("605", 1, bytes, 127 * 7)), (Frames{"585#A2017F0000000000"}));
    EXPECT_EQ(send(block_end("605", bytes)), (Frames{"585#A100000000000000"}));
    EXPECT_EQ(held(), bytes);
}

TEST_F(SdoBlock, EmptyValueCanBeDownloaded) {
    verifies<req::CO_SDO_038>();
    hold({1});
    talk(*this, {
                    {"605#C600240000000000", {"585#A40024007F000000"}},
                    {"605#8100000000000000", {"585#A2017F0000000000"}},
                    {"605#DD00000000000000", {"585#A100000000000000"}},
                    {"605#4000240000000000", {"585#4100240000000000"}},
                    {"605#6000000000000000", {"585#0F00000000000000"}},
                });
}

TEST_F(SdoBlock, BlockDownloadsToOrdinaryEntriesAreCheckedLikeOtherDownloads) {
    verifies<req::CO_SDO_029, req::CO_SDO_052, req::CO_SDO_010, req::CO_SDO_011, req::CO_E_ABORT, req::CO_SDO_059>();
    const auto block_of = [](const std::string& object, const Bytes& bytes, const std::string& last) {
        return std::vector<Exchange>{
            {"605#C4" + object + "00000000", {"585#A4" + object + "7F000000"}},
            {block_segment("605", 1, bytes, 0), {"585#A2017F0000000000"}},
            {block_end("605", bytes), {last}},
        };
    };
    const std::string done = "585#A100000000000000";
    talk(*this, block_of("002200", {0x64, 0x00}, done));                          // writes 100 to 2200h
    talk(*this, block_of("002200", {0x65, 0x00}, "585#8000220031000906"));        // 101 is above the maximum of 2200h
    talk(*this, block_of("002200", {0x9B, 0xFF}, "585#8000220032000906"));        // -101 is below the minimum of 2200h
    talk(*this, block_of("002200", {0x01}, "585#8000220013000706"));              // the value is one byte too short
    talk(*this, block_of("002200", {0x01, 0x00, 0x00}, "585#8000220012000706"));  // the value is one byte too long
    talk(*this, {{"605#4000220000000000", {"585#4B00220064000000"}}});            // 2200h is still 100
    talk(*this, block_of("012200", {5}, "585#8001220030000906"));                 // 2201h accepts 2 and 8 only
    talk(*this, block_of("002300", {'x', 'y', 'z', 'z', 'y'}, done));             // the string 2300h may be shorter
    talk(*this, {{"605#4000230000000000", {"585#4100230005000000"}}});
    talk(*this, block_of("101001", {'s', 'a', 'v', 'x'}, "585#8010100120000008"));  // not the signature
}

TEST_F(SdoBlock, BlockDownloadThatCannotSucceedIsRefusedAtItsInitiate) {
    verifies<req::CO_SDO_008, req::CO_SDO_009, req::CO_SDO_010, req::CO_SDO_034, req::CO_SDO_057>();
    talk(*this, {
                    {"605#C600100004000000", {"585#8000100002000106"}},
                    {"605#C602240004000000", {"585#8002240002000106"}},  // a read-only DOMAIN
                    {"605#C634120004000000", {"585#8034120000000206"}},
                    {"605#C600220104000000", {"585#8000220111000906"}},
                    {"605#C600220003000000", {"585#8000220012000706"}},  // three bytes for an INTEGER16
                    {"605#C600240001000100", {"585#8000240012000706"}},  // the size is 65,537 bytes
                    {"605#C6002400FFFFFFFF", {"585#8000240012000706"}},
                    {"605#C601240004000000", {"585#8001240005000405"}},  // 2401h has no memory for the data
                    {"605#0131323334353637", {stray}},
                });
}

TEST_F(SdoBlock, DownloadOfAnotherLengthThanAnnouncedIsRefused) {
    verifies<req::CO_SDO_047, req::CO_E_ABORT, req::CO_SDO_060>();
    hold({1});
    for (const std::string size : {"08", "0A", "00"}) {
        talk(*this, {
                        {"605#C6002400" + size + "000000", {"585#A40024007F000000"}},
                        {"605#0131323334353637", {}},
                        {"605#8238390000000000", {"585#A2027F0000000000"}},
                        {"605#D5C3310000000000", {"585#8000240010000706"}},
                    });
    }
    EXPECT_EQ(held(), Bytes{1});
}

TEST_F(SdoBlock, DownloadLongerThanTheEntryIsRefusedWhileItArrives) {
    verifies<req::CO_SDO_010>();
    // 2300h accepts 40 bytes. Five segments have 35 bytes; a sixth may be the last one, with 2 unused bytes; a seventh
    // is too much.
    talk(*this, {
                    {"605#C400230000000000", {"585#A40023007F000000"}},
                    {"605#0141414141414141", {}},
                    {"605#0241414141414141", {}},
                    {"605#0341414141414141", {}},
                    {"605#0441414141414141", {}},
                    {"605#0541414141414141", {}},
                    {"605#0641414141414141", {}},
                    {"605#0741414141414141", {"585#8000230012000706"}},
                    {"605#4000230000000000", {"585#4700230061626300"}},
                });
}

TEST_F(SdoBlock, SubBlocksWithoutTheirMiddleSegmentsDoNotOverrunTheMemory) {
    verifies<req::CO_SDO_010, req::CO_SDO_026, req::CO_SDO_050>();
    // Each pair of segments ends a sub-block. Only the first segment of the pair has the expected number, so seven
    // bytes of each pair are accepted.
    talk(*this, {{"605#C400230000000000", {"585#A40023007F000000"}}});
    for (int pair = 0; pair < 6; ++pair) {
        talk(*this, {{"605#0141414141414141", {}}, {"605#7F42424242424242", {"585#A2017F0000000000"}}});
    }
    talk(*this, {
                    {"605#0141414141414141", {"585#8000230012000706"}},
                    {"605#4000230000000000", {"585#4700230061626300"}},
                });
    // the same pairs, written to 2400h, a DOMAIN of 64 KiB: 9,363 pairs are 9,363 * 7 = 65,541 bytes
    ASSERT_EQ(send("605#C400240000000000"), (Frames{"585#A40024007F000000"}));
    for (int pair = 0; pair < 9363; ++pair) {
        ASSERT_TRUE(send("605#0141414141414141").empty());
        ASSERT_EQ(send("605#7F42424242424242"), (Frames{"585#A2017F0000000000"}));
    }
    EXPECT_EQ(send("605#0141414141414141"), (Frames{"585#8000240012000706"}));
    EXPECT_EQ(device->held(program_index, 0).size(), 0U);
}

TEST_F(SdoBlock, SequenceNumberZeroAbortsTheDownload) {
    verifies<req::CO_SDO_027, req::CO_SDO_030, req::CO_E_ABORT>();
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0031323334353637", {"585#8000240003000405"}},
                    {"605#0131323334353637", {stray}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#8000240000000008", {}},  // the client aborts its download
                    {"605#0131323334353637", {stray}},
                });
}

TEST_F(SdoBlock, EveryFrameCountsAsASegmentUntilTheLastSegmentHasArrived) {
    verifies<req::CO_SDO_030, req::CO_SDO_012>();
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#4000100000000000", {}},                        // counts as segment 64, out of order
                    {"605#2F01220008000000", {}},                        // counts as segment 47, out of order
                    {"605#C600240009000000", {"585#A2017F0000000000"}},  // counts as segment 70, marked as the last
                    {"605#8138390000000000", {"585#A2017F0000000000"}},
                    // The sub-block is complete now. A frame with the command of an initiate request is such a request
                    // again, and no segment.
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_TRUE(held().empty());
}

TEST_F(SdoBlock, DeviceMayRefuseADownloadedDomain) {
    verifies<req::CO_SDO_047>();
    hold({7});
    device->refuse_domains_with(AbortCode::hardware_error);
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5C3310000000000", {"585#8000240000000606"}},
                    {"605#2300240001020304", {"585#8000240000000606"}},
                });
    EXPECT_EQ(held(), Bytes{7});
}

TEST_F(SdoBlock, AllFourBytesOfTheAnnouncedSizeAreEvaluated) {
    verifies<req::CO_SDO_010>();
    talk(*this, {
                    {"605#2100240001000100", {"585#8000240012000706"}},  // 10001h bytes: one more than the memory
                    {"605#2100240001000001", {"585#8000240012000706"}},  // 1000001h
                    // announces 101h bytes, but the only segment has one byte
                    {"605#2100240001010000", {"585#6000240000000000"}},
                    {"605#0D09000000000000", {"585#8000240010000706"}},
                });
    EXPECT_EQ(send("605#2100240000000100"), (Frames{"585#6000240000000000"}));  // 10000h bytes
    for (std::size_t from = 0; from < program_size; from += 7) {
        const bool last = from + 7 >= program_size;  // 65,536 = 9,362 * 7 + 2: the last segment has two bytes
        const unsigned command = (from / 7 % 2 == 1 ? 0x10U : 0U) | (last ? 0x0BU : 0U);
        const std::string data = last ? "5A5A0000000000" : "5A5A5A5A5A5A5A";
        ASSERT_EQ(send("605#" + hex_le(command, 1) + data),
                  (Frames{"585#" + hex_le(0x20U | (command & 0x10U), 1) + "00000000000000"}));
    }
    EXPECT_EQ(device->held(program_index, 0).size(), program_size);
}

TEST_F(SdoBlock, DomainAlsoAcceptsExpeditedAndSegmentedDownloads) {
    verifies<req::CO_SDO_033, req::CO_SDO_016>();
    talk(*this, {
                    {"605#2300240001020304", {"585#6000240000000000"}},
                    {"605#4000240000000000", {"585#4300240001020304"}},
                    {"605#2F00240009000000", {"585#6000240000000000"}},
                    {"605#4000240000000000", {"585#4F00240009000000"}},
                    {"605#2200240005060708", {"585#6000240000000000"}},
                    {"605#4000240000000000", {"585#4300240005060708"}},
                    {"605#2100240009000000", {"585#6000240000000000"}},
                    {"605#0031323334353637", {"585#2000000000000000"}},
                });
    EXPECT_EQ(held(), (Bytes{5, 6, 7, 8}));
    talk(*this, {{"605#1B38390000000000", {"585#3000000000000000"}}});
    EXPECT_EQ(held(), nine);
    talk(*this, {{"605#2301240001020304", {"585#8001240005000405"}},    // 2401h has no memory
                 {"605#2302240001020304", {"585#8002240002000106"}}});  // 2402h is read-only
}

// -- a device without block transfer ----------------------------------------------------------------------------------

using SdoWithoutBlock = CbxTest;

TEST_F(SdoWithoutBlock, BlockRequestsAreUnknownCommands) {
    verifies<req::CO_SDO_006, req::CO_SDO_018>();
    const std::string refused = "583#8000000001000405";
    talk(*this, {
                    {"603#A40810007F000000", {"583#8008100001000405"}},
                    {"603#A00810007F000000", {"583#8008100001000405"}},
                    {"603#A100000000000000", {refused}},
                    {"603#A2017F0000000000", {refused}},
                    {"603#A300000000000000", {refused}},
                    {"603#C617100002000000", {"583#8017100001000405"}},
                    {"603#C017100000000000", {"583#8017100001000405"}},
                    {"603#C1ABCD0000000000", {refused}},
                    {"603#0131323334353637", {refused}},
                    // a block request during a transfer ends it
                    {"603#4008100000000000", {"583#410810000D000000"}},
                    {"603#A300000000000000", {"583#8008100001000405"}},
                    {"603#6000000000000000", {refused}},
                });
}

}  // namespace canproof::test
