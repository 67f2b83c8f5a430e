// SPDX-License-Identifier: Apache-2.0
// Tests SDO block upload (CiA 301, 7.2.4.3.12 to 7.2.4.3.16) with complete exchanges of frames.
#include "firmware/base/crc16.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/sdo_block_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(Crc16, CrcOfTheDigits1To9IsTheCheckValueOfCiA301) {
    verifies<req::CO_SDO_025, req::CO_SDO_028>();
    Crc16 crc;
    crc.add(ByteView{nine.data(), 4});
    crc.add(ByteView{nine.data() + 4, 5});
    EXPECT_EQ(crc.value(), 0x31C3);
    for (unsigned byte = 0; byte < 256; ++byte) {
        const Bytes one{static_cast<std::uint8_t>(byte), 0xA5};
        Crc16 ours;
        ours.add(ByteView{one.data(), one.size()});
        EXPECT_EQ(ours.value(), crc16_bit_by_bit(one)) << byte;
    }
}

// -- upload -----------------------------------------------------------------------------------------------------------

TEST_F(SdoBlock, UploadOfNineBytesReturnsThem) {
    verifies<req::CO_SDO_020, req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_025, req::CO_SDO_049, req::CO_SDO_032>();
    hold(nine);
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637", "585#8238390000000000"}},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},  // C1h | 5 unused bytes << 2
                    {"605#A100000000000000", {}},
                    {"605#A100000000000000", {stray}},
                });
}

TEST_F(SdoBlock, UploadToAClientWithoutCrcEndsWithZeroAsCrc) {
    verifies<req::CO_SDO_020, req::CO_SDO_054>();
    hold(nine);
    talk(*this, {
                    {"605#A00024007F000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637", "585#8238390000000000"}},
                    {"605#A2027F0000000000", {"585#D500000000000000"}},  // the CRC field is 0; a CRC would be 31C3h
                    {"605#A100000000000000", {}},
                });
    talk(*this, {
                    // for the next transfer the client asks for a CRC (A4h)
                    {"605#A400240001000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637"}},
                    {"605#A201010000000000", {"585#8138390000000000"}},
                    {"605#A2017F0000000000", {"585#D5C3310000000000"}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, UploadIsSentInSubBlocksOfTwoSegments) {
    verifies<req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_022>();
    const Bytes bytes = counting(30);  // 5 segments in sub-blocks of 2, 2 and 1; the last segment has 2 bytes
    hold(bytes);
    talk(*this, {
                    {"605#A400240002000000", {"585#C60024001E000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A202020000000000", {"585#010F101112131415", "585#02161718191A1B1C"}},
                    {"605#A202020000000000", {"585#811D1E0000000000"}},
                    {"605#A201020000000000", {block_end("585", bytes)}},  // D5h: 5 bytes of the last segment are unused
                    {"605#A100000000000000", {}},
                });
    EXPECT_EQ(block_end("585", bytes).substr(0, 6), "585#D5");
}

TEST_F(SdoBlock, EachAcknowledgementOfAnUploadGivesTheNextBlockSize) {
    verifies<req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_022>();
    const Bytes bytes = counting(30);  // 5 segments, in sub-blocks of 1, 3 and 1
    hold(bytes);
    talk(*this, {
                    {"605#A400240001000000", {"585#C60024001E000000"}},
                    {"605#A300000000000000", {"585#0101020304050607"}},
                    {"605#A201030000000000", {"585#0108090A0B0C0D0E", "585#020F101112131415", "585#03161718191A1B1C"}},
                    {"605#A203010000000000", {"585#811D1E0000000000"}},
                    {"605#A201010000000000", {block_end("585", bytes)}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, LostUploadSegmentsAreSentAgain) {
    verifies<req::CO_SDO_022>();
    const Bytes bytes = counting(21);  // three full segments
    hold(bytes);
    const Frames whole{"585#0101020304050607", "585#0208090A0B0C0D0E", "585#830F101112131415"};
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", whole},
                    {"605#A2007F0000000000", whole},  // the client acknowledges no segment: all are repeated
                    {"605#A2017F0000000000",
                     {"585#0108090A0B0C0D0E", "585#820F101112131415"}},  // the client acknowledges the first segment
                    {"605#A201010000000000", {"585#810F101112131415"}},  // the client acknowledges the second segment
                                                                         // and sets a block size of one segment
                    {"605#A200010000000000", {"585#810F101112131415"}},
                    {"605#A201010000000000", {block_end("585", bytes)}},
                    {"605#A100000000000000", {}},
                });
    EXPECT_EQ(block_end("585", bytes).substr(0, 6), "585#C1");  // the last segment has no unused byte
}

TEST_F(SdoBlock, RepeatedSegmentCountsOnceInTheCrc) {
    verifies<req::CO_SDO_025>();
    hold(nine);
    talk(*this, {
                    {"605#A400240001000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637"}},
                    {"605#A200010000000000", {"585#0131323334353637"}},
                    {"605#A201010000000000", {"585#8138390000000000"}},
                    {"605#A200010000000000", {"585#8138390000000000"}},
                    {"605#A201010000000000", {"585#D5C3310000000000"}},
                });
}

TEST_F(SdoBlock, AcknowledgementOfAnUnsentSegmentIsRefused) {
    verifies<req::CO_SDO_023, req::CO_E_ABORT>();
    hold(counting(21));
    talk(*this, {
                    // three segments were sent, the last one included: an acknowledgement of four is wrong
                    {"605#A40024007F000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E", "585#830F101112131415"}},
                    {"605#A2047F0000000000", {"585#8000240003000405"}},
                    {"605#A2037F0000000000", {stray}},
                    // in a sub-block of two segments, an acknowledgement of three is wrong
                    {"605#A400240002000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A203020000000000", {"585#8000240003000405"}},
                    {"605#A400240002000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A2FF020000000000", {"585#8000240003000405"}},
                });
}

TEST_F(SdoBlock, BlockSizesOtherThan1To127AreRefused) {
    verifies<req::CO_SDO_024, req::CO_E_ABORT>();
    hold(nine);
    talk(*this, {
                    {"605#A400240000000000", {"585#8000240002000405"}},
                    {"605#A400240080000000", {"585#8000240002000405"}},
                    {"605#A4002400FF000000", {"585#8000240002000405"}},
                    {"605#A300000000000000", {stray}},
                    {"605#A400240001000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637"}},
                    {"605#A201000000000000", {"585#8000240002000405"}},
                    {"605#A400240001000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637"}},
                    {"605#A201800000000000", {"585#8000240002000405"}},
                });
}

TEST_F(SdoBlock, ValuesUpToTheProtocolSwitchThresholdAreUploadedWithoutBlocks) {
    verifies<req::CO_SDO_031>();
    hold(nine);
    talk(*this, {
                    // protocol switch threshold 9: a value of nine bytes is uploaded without blocks
                    {"605#A40024007F090000", {"585#4100240009000000"}},
                    {"605#6000000000000000", {"585#0031323334353637"}},
                    {"605#7000000000000000", {"585#1B38390000000000"}},
                    // threshold 8 is below the size of nine bytes; threshold 0 always gives a block upload
                    {"605#A40024007F080000", {"585#C600240009000000"}},
                    {"605#A40024007F000000", {"585#C600240009000000"}},
                    // values of one to four bytes are sent expedited
                    {"605#A40010007F040000", {"585#4300100078563412"}},
                    {"605#A40010007F030000", {"585#C600100004000000"}},
                    {"605#A40122007FFF0000", {"585#4F01220002000000"}},
                });
}

TEST_F(SdoBlock, ValuesOfTwoAndThreeBytesUpToTheThresholdAreUploadedExpedited) {
    verifies<req::CO_SDO_031>();
    talk(*this, {
                    {"605#A40022007F020000", {"585#4B00220007000000"}},  // 2200h is 7
                    {"605#A40022007F010000", {"585#C600220002000000"}},
                    {"605#A40023007F030000", {"585#4700230061626300"}},  // 2300h is "abc"
                    {"605#A40023007F020000", {"585#C600230003000000"}},
                });
}

TEST_F(SdoBlock, NumbersAndStringsCanBeUploadedInABlock) {
    verifies<req::CO_SDO_020, req::CO_SDO_048>();
    talk(*this, {
                    {"605#A40010007F000000", {"585#C600100004000000"}},  // 1000h (device type), 12345678h
                    {"605#A300000000000000", {"585#8178563412000000"}},
                    {"605#A2017F0000000000", {block_end("585", {0x78, 0x56, 0x34, 0x12})}},
                    {"605#A100000000000000", {}},
                    {"605#A40023007F000000", {"585#C600230003000000"}},  // "abc"
                    {"605#A300000000000000", {"585#8161626300000000"}},
                    {"605#A2017F0000000000", {block_end("585", {'a', 'b', 'c'})}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, BlockUploadOfAnEmptyValueIsOneSegmentWithoutData) {
    verifies<req::CO_SDO_038>();
    hold({});
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240000000000"}},
                    {"605#A300000000000000", {"585#8100000000000000"}},
                    // DDh = C1h + 7 unused bytes << 2; the CRC of no data is 0
                    {"605#A2017F0000000000", {"585#DD00000000000000"}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, BlockUploadOfAnUnreadableEntryIsRefusedAtOnce) {
    verifies<req::CO_SDO_008, req::CO_SDO_046, req::CO_SDO_057, req::CO_SDO_058, req::CO_SDO_061>();
    talk(*this, {
                    {"605#A43412007F000000", {"585#8034120000000206"}},
                    {"605#A40010017F000000", {"585#8000100111000906"}},
                    {"605#A40522007F000000", {"585#8005220001000106"}},
                    {"605#A40024007F000000", {"585#8000240024000008"}},  // no value was ever written to 2400h
                    {"605#A40124007F000000", {"585#8001240000000106"}},  // 2401h has no memory
                    {"605#A300000000000000", {stray}},
                });
}

TEST_F(SdoBlock, SixtyFourKibibytesAreUploadedCompletely) {
    verifies<req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_032, req::CO_SDO_039, req::CO_K_SDO_BLOCK_SIZE,
             req::CO_K_SDO_BLOCK_QUEUED>();
    // The test computes the value in pieces, because this test also runs on the microcontroller: its memory has no room
    // for the whole value beside the slave and the answers.
    const auto piece = [](std::size_t from, std::size_t size) {
        Bytes bytes(size);
        for (std::size_t i = 0; i < size; ++i) {
            bytes[i] = static_cast<std::uint8_t>((from + i) * 7 + (from + i) / 256);
        }
        return bytes;
    };
    constexpr std::size_t all = SlaveBench::program_size;
    const std::string end = block_end("585", piece(0, all));
    hold(piece(0, all));
    EXPECT_EQ(send("605#A40024007F000000"), (Frames{"585#C600240000000100"}));  // 10000h
    std::string request = "605#A300000000000000";
    std::size_t from = 0;
    std::size_t sub_blocks = 0;
    while (from < all) {
        const bool last = all - from <= 7 * 127;
        const Bytes bytes = piece(from, last ? all - from : 7 * 127 + 1);  // one byte more than 127 segments, so that
                                                                           // segment 127 is not marked as the last
        Frames expected;
        for (unsigned sequence = 1; sequence <= 127 && (sequence - 1) * 7 < bytes.size(); ++sequence) {
            expected.push_back(block_segment("585", sequence, bytes, (sequence - 1) * 7));
        }
        from += 7 * 127;
        ASSERT_EQ(all_segments(request), expected);
        request = "605#A2" + hex_le(expected.size(), 1) + "7F0000000000";
        ++sub_blocks;
    }
    EXPECT_EQ(sub_blocks, 74U);  // 65,536 bytes / (7 × 127 bytes per block) = 73.7 blocks
    EXPECT_EQ(send(request), (Frames{end}));
    EXPECT_TRUE(send("605#A100000000000000").empty());
}

TEST_F(SdoBlock, AtMostEightUploadSegmentsWaitInTheQueue) {
    verifies<req::CO_SDO_039, req::CO_SDO_053, req::CO_K_SDO_BLOCK_QUEUED>();
    hold(counting(140));  // 140 bytes need 20 segments of 7
    send("605#A40024007F000000");
    device->receive(host::parse_frame("605#A300000000000000", "test"), now);
    EXPECT_EQ(queue.size(), 8U);
    device->advance(now);
    EXPECT_EQ(queue.size(), 8U);
    queue.pop();
    EXPECT_EQ(device->next_deadline().us, now.us);  // the queue has room again, so the upload is due at once
    device->advance(now);
    EXPECT_EQ(queue.size(), 8U);
    // the SDO time-out starts when the last segment is put into the queue, however slowly the bus takes the frames
    now = now + milliseconds(900);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(sent().size(), 3U);  // 8 + 1 + 8 + 3 = 20 segments
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:585#8000240000000405"}));
}

/// The program empties the queue and calls the server only after the SDO time-out. The client is not late, so the
/// server must not abort the upload.
TEST_F(SdoBlock, BlockUploadContinuesWhenTheQueueIsEmptiedOnlyAfterTheTimeOut) {
    verifies<req::CO_SDO_014, req::CO_SDO_039>();
    hold(counting(140));  // 20 segments
    send("605#A40024007F000000");
    device->receive(host::parse_frame("605#A300000000000000", "test"), now);
    now = now + milliseconds(1000);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(sent().size(), 8U);
}

/// The identifier of the segments, 585h, is below that of the heartbeat, 705h.
TEST_F(SdoBlock, UploadSegmentsLeaveBeforeAHeartbeatThatAlreadyWaits) {
    verifies<req::CO_FRAME_002>();
    hold(counting(35));            // five segments in sub-blocks of two
    send("605#2B17100064000000");  // 1017h producer heartbeat time: 100 ms
    send("605#A400240002000000");
    const auto answers_behind_a_heartbeat = [this](const char* request) {
        is_blocked = true;
        EXPECT_EQ(pass(100), Frames{});
        EXPECT_EQ(queue.size(), 1U);  // the heartbeat waits
        EXPECT_EQ(send(request), Frames{});
        is_blocked = false;
        return sent();
    };
    EXPECT_EQ(answers_behind_a_heartbeat("605#A300000000000000"),
              (Frames{"585#0101020304050607", "585#0208090A0B0C0D0E", "705#7F"}));
    EXPECT_EQ(answers_behind_a_heartbeat("605#A202020000000000"),
              (Frames{"585#010F101112131415", "585#02161718191A1B1C", "705#7F"}));
    EXPECT_EQ(answers_behind_a_heartbeat("605#A202020000000000"), (Frames{"585#811D1E1F20212223", "705#7F"}));
}

TEST_F(SdoBlock, BlockUploadContinuesAfterAnNmtCommand) {
    verifies<req::CO_SDO_039>();
    hold(counting(140));
    send("605#A40024007F000000");
    device->receive(host::parse_frame("605#A300000000000000", "test"), now);
    device->receive(host::parse_frame("000#8005", "test"), now);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(queue.size(), 8U);
}

TEST_F(SdoBlock, DomainCanAlsoBeUploadedInSegments) {
    verifies<req::CO_SDO_032>();
    hold(counting(100));
    EXPECT_EQ(send("605#4000240000000000"), (Frames{"585#4100240064000000"}));
    for (unsigned segment = 0; segment < 15; ++segment) {
        const unsigned toggle = (segment % 2) * 0x10;
        const std::size_t from = segment * std::size_t{7};
        // 14 segments carry 98 bytes; the last one carries 2, so five bytes are unused
        const bool last = segment == 14;
        const std::string request = "605#" + hex_le(0x60U | toggle, 1) + "00000000000000";
        const unsigned command = toggle | (last ? 0x0BU : 0U);
        EXPECT_EQ(send(request), (Frames{"585#" + hex_le(command, 1) + hex_bytes(counting(100), from, 7, 7)}));
    }
    EXPECT_EQ(send("605#6000000000000000"), (Frames{stray}));
}

TEST_F(SdoBlock, ValueWhoseLengthIsAMultipleOfSevenEndsWithAFullSegment) {
    verifies<req::CO_SDO_002, req::CO_SDO_055>();
    hold(counting(14));
    talk(*this, {
                    {"605#4000240000000000", {"585#410024000E000000"}},
                    {"605#6000000000000000", {"585#0001020304050607"}},
                    // the answer 11h has the toggle bit, no unused bytes, and the mark of the last segment
                    {"605#7000000000000000", {"585#1108090A0B0C0D0E"}},
                    {"605#6000000000000000", {stray}},
                });
}

TEST_F(SdoBlock, LongValueWithoutMemoryOfTheDeviceIsUploadedButNotDownloaded) {
    verifies<req::CO_K_SDO_BUFFER, req::CO_SDO_034>();
    EXPECT_EQ(send("605#4002230000000000"), (Frames{"585#4102230048000000"}));  // 72 bytes
    EXPECT_EQ(send("605#6000000000000000"), (Frames{"585#00412076616C7565"}));  // "A value"
    EXPECT_EQ(send("605#A402230001000000"), (Frames{"585#C602230048000000"}));
    EXPECT_EQ(send("605#A300000000000000"), (Frames{"585#01412076616C7565"}));
    // 2302h cannot be downloaded, neither in segments nor in blocks
    EXPECT_EQ(send("605#2002230000000000"), (Frames{"585#8002230005000405"}));
    EXPECT_EQ(send("605#C002230000000000"), (Frames{"585#8002230005000405"}));
}

TEST_F(SdoBlock, ShortValueIsSentAsItWasAtTheStartOfTheUpload) {
    verifies<req::CO_SDO_048>();
    send("000#0105");  // NMT command start
    talk(*this, {
                    {"605#A40022007F000000", {"585#C600220002000000"}},  // 2200h = 7
                    {"605#A300000000000000", {"585#8107000000000000"}},
                    {"605#A2007F0000000000", {"585#8107000000000000"}},
                    {"605#A40121017F000000", {"585#C601210102000000"}},  // 2101h:1 = 0
                    {"605#A300000000000000", {"585#8100000000000000"}},
                });
    device->objects().write(0x2101, 1, 0x1234);  // the device changes the value
    EXPECT_EQ(send("605#A2007F0000000000"), (Frames{"585#8100000000000000"}));
    // The end of the upload has five unused bytes and the CRC of the old value 0000h.
    EXPECT_EQ(send("605#A2017F0000000000"), (Frames{"585#D500000000000000"}));
}

}  // namespace canproof::test
