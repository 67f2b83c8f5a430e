// SDO block transfer (CiA 301, 7.2.4.3.8 to 7.2.4.3.16): whole conversations with the conformance slave, node 5. 2400h
// is its DOMAIN of 64 KiB. "123456789" has the CRC 31C3h.
#include "firmware/base/crc16.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

const Bytes nine{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
const std::string stray = "585#8000000001000405";  // 05040001h, and no object to name

class SdoBlock : public testing::Test, public SlaveBench {
  protected:
    Bytes held() const {
        const ByteView view = device->held(program_index, 0);
        return {view.data(), view.data() + view.size()};
    }
    void hold(const Bytes& bytes) { device->fill(program_index, 0, bytes); }

    /// The segments that leave when nothing is lost: the first eight at once, the rest as the queue empties.
    Frames all_segments(const std::string& request) {
        Frames frames = send(request);
        for (const auto& later : pass(0)) {
            frames.push_back(later.substr(2));  // without "0:"
        }
        return frames;
    }
};

}  // namespace

TEST(Crc16, HasTheCheckValueOfCiA301) {
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

TEST_F(SdoBlock, UploadOfNineBytes) {
    verifies<req::CO_SDO_020, req::CO_SDO_021, req::CO_SDO_025, req::CO_SDO_032>();
    hold(nine);
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637", "585#8238390000000000"}},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},  // C1h | 5 << 2
                    {"605#A100000000000000", {}},
                    {"605#A100000000000000", {stray}},
                });
}

TEST_F(SdoBlock, UploadToAClientWithoutCrc) {
    verifies<req::CO_SDO_020>();
    hold(nine);
    talk(*this, {
                    {"605#A00024007F000000", {"585#C600240009000000"}},
                    {"605#A300000000000000", {"585#0131323334353637", "585#8238390000000000"}},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, UploadInSubBlocksOfTwo) {
    verifies<req::CO_SDO_021, req::CO_SDO_022>();
    const Bytes bytes = counting(30);  // 5 segments: 2, 2 and 1, the last with 2 bytes
    hold(bytes);
    talk(*this, {
                    {"605#A400240002000000", {"585#C60024001E000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A202020000000000", {"585#010F101112131415", "585#02161718191A1B1C"}},
                    {"605#A202020000000000", {"585#811D1E0000000000"}},
                    {"605#A201020000000000", {block_end("585", bytes)}},  // 5 unused
                    {"605#A100000000000000", {}},
                });
    EXPECT_EQ(block_end("585", bytes).substr(0, 6), "585#D5");
}

TEST_F(SdoBlock, WhatTheClientDidNotGetComesAgain) {
    verifies<req::CO_SDO_022>();
    const Bytes bytes = counting(21);  // three full segments
    hold(bytes);
    const Frames whole{"585#0101020304050607", "585#0208090A0B0C0D0E", "585#830F101112131415"};
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", whole},
                    {"605#A2007F0000000000", whole},                                             // none came
                    {"605#A2017F0000000000", {"585#0108090A0B0C0D0E", "585#820F101112131415"}},  // the first did
                    {"605#A201010000000000", {"585#810F101112131415"}},  // the second did; one at a time from now on
                    {"605#A200010000000000", {"585#810F101112131415"}},
                    {"605#A201010000000000", {block_end("585", bytes)}},
                    {"605#A100000000000000", {}},
                });
    EXPECT_EQ(block_end("585", bytes).substr(0, 6), "585#C1");  // no byte unused
}

TEST_F(SdoBlock, ARepeatedSegmentCountsOnceInTheCrc) {
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

TEST_F(SdoBlock, OnlySegmentsThatWereSentCanBeAcknowledged) {
    verifies<req::CO_SDO_023, req::CO_E_ABORT>();
    hold(counting(21));
    talk(*this, {
                    // three were sent, the last one among them: four is not a success
                    {"605#A40024007F000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E", "585#830F101112131415"}},
                    {"605#A2047F0000000000", {"585#8000240003000405"}},
                    {"605#A2037F0000000000", {stray}},
                    // two of three were sent
                    {"605#A400240002000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A203020000000000", {"585#8000240003000405"}},
                    {"605#A400240002000000", {"585#C600240015000000"}},
                    {"605#A300000000000000", {"585#0101020304050607", "585#0208090A0B0C0D0E"}},
                    {"605#A2FF020000000000", {"585#8000240003000405"}},
                });
}

TEST_F(SdoBlock, BlockSizesAreOneTo127) {
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

TEST_F(SdoBlock, SmallValuesAreSwitchedToAPlainUpload) {
    verifies<req::CO_SDO_031>();
    hold(nine);
    talk(*this, {
                    // threshold 9: not more than nine bytes
                    {"605#A40024007F090000", {"585#4100240009000000"}},
                    {"605#6000000000000000", {"585#0031323334353637"}},
                    {"605#7000000000000000", {"585#1B38390000000000"}},
                    // threshold 8 is below the size, 0 says never
                    {"605#A40024007F080000", {"585#C600240009000000"}},
                    {"605#A40024007F000000", {"585#C600240009000000"}},
                    // one to four bytes: expedited
                    {"605#A40010007F040000", {"585#4300100078563412"}},
                    {"605#A40010007F030000", {"585#C600100004000000"}},
                    {"605#A40122007FFF0000", {"585#4F01220002000000"}},
                });
}

TEST_F(SdoBlock, AnyValueCanBeUploadedInABlock) {
    verifies<req::CO_SDO_020, req::CO_SDO_021>();
    talk(*this, {
                    {"605#A40010007F000000", {"585#C600100004000000"}},  // 1000h, 12345678h
                    {"605#A300000000000000", {"585#8178563412000000"}},
                    {"605#A2017F0000000000", {block_end("585", {0x78, 0x56, 0x34, 0x12})}},
                    {"605#A100000000000000", {}},
                    {"605#A40023007F000000", {"585#C600230003000000"}},  // "abc"
                    {"605#A300000000000000", {"585#8161626300000000"}},
                    {"605#A2017F0000000000", {block_end("585", {'a', 'b', 'c'})}},
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, AnEmptyValueIsOneSegmentWithoutData) {
    verifies<req::CO_SDO_038>();
    hold({});
    talk(*this, {
                    {"605#A40024007F000000", {"585#C600240000000000"}},
                    {"605#A300000000000000", {"585#8100000000000000"}},
                    {"605#A2017F0000000000", {"585#DD00000000000000"}},  // C1h | 7 << 2, CRC of nothing
                    {"605#A100000000000000", {}},
                });
}

TEST_F(SdoBlock, WhatCannotBeReadIsRefusedAtOnce) {
    verifies<req::CO_SDO_008, req::CO_SDO_009, req::CO_SDO_032>();
    talk(*this, {
                    {"605#A43412007F000000", {"585#8034120000000206"}},
                    {"605#A40010017F000000", {"585#8000100111000906"}},
                    {"605#A40522007F000000", {"585#8005220001000106"}},
                    {"605#A40024007F000000", {"585#8000240024000008"}},  // nothing was ever put there
                    {"605#A40124007F000000", {"585#8001240000000106"}},  // no memory behind it
                    {"605#A300000000000000", {stray}},
                });
}

TEST_F(SdoBlock, SixtyFourKibibytes) {
    verifies<req::CO_SDO_021, req::CO_SDO_032, req::CO_SDO_039, req::CO_K_SDO_BLOCK_SIZE, req::CO_K_SDO_BLOCK_QUEUED>();
    // A piece at a time: the microcontroller has no room for all of it beside the slave's and the answers.
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
        const Bytes bytes = piece(from, last ? all - from : 7 * 127 + 1);  // one more: block_segment marks the last
        Frames expected;
        for (unsigned sequence = 1; sequence <= 127 && (sequence - 1) * 7 < bytes.size(); ++sequence) {
            expected.push_back(block_segment("585", sequence, bytes, (sequence - 1) * 7));
        }
        from += 7 * 127;
        ASSERT_EQ(all_segments(request), expected);
        request = "605#A2" + hex_le(expected.size(), 1) + "7F0000000000";
        ++sub_blocks;
    }
    EXPECT_EQ(sub_blocks, 74U);  // 65,536 / (7 × 127) = 73.7
    EXPECT_EQ(send(request), (Frames{end}));
    EXPECT_TRUE(send("605#A100000000000000").empty());
}

TEST_F(SdoBlock, NoMoreThanEightSegmentsWait) {
    verifies<req::CO_SDO_039, req::CO_K_SDO_BLOCK_QUEUED>();
    hold(counting(140));  // 20 segments
    send("605#A40024007F000000");
    device->receive(host::parse_frame("605#A300000000000000", "test"), now);
    EXPECT_EQ(queue.size(), 8U);
    device->advance(now);
    EXPECT_EQ(queue.size(), 8U);
    queue.pop();
    EXPECT_EQ(device->next_deadline().us, now.us);  // room again: due at once
    device->advance(now);
    EXPECT_EQ(queue.size(), 8U);
    // the time-out counts from the last segment queued, however slowly the bus takes them
    now = now + milliseconds(900);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(sent().size(), 8U);
    device->advance(now);
    EXPECT_EQ(sent().size(), 3U);  // 8 + 1 + 8 + 3
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), (Frames{"1:585#8000240000000405"}));
}

TEST_F(SdoBlock, ASegmentedUploadFitsTheSameMemory) {
    verifies<req::CO_SDO_032>();
    hold(counting(100));
    EXPECT_EQ(send("605#4000240000000000"), (Frames{"585#4100240064000000"}));
    for (unsigned segment = 0; segment < 15; ++segment) {
        const unsigned toggle = (segment % 2) * 0x10;
        const std::size_t from = segment * std::size_t{7};
        const bool last = segment == 14;  // 98 bytes, and two: five unused
        const std::string request = "605#" + hex_le(0x60U | toggle, 1) + "00000000000000";
        const unsigned command = toggle | (last ? 0x0BU : 0U);
        EXPECT_EQ(send(request), (Frames{"585#" + hex_le(command, 1) + hex_bytes(counting(100), from, 7, 7)}));
    }
    EXPECT_EQ(send("605#6000000000000000"), (Frames{stray}));
}

TEST_F(SdoBlock, AValueOfWholeSegmentsEndsWithAFullOne) {
    verifies<req::CO_SDO_002>();
    hold(counting(14));
    talk(*this, {
                    {"605#4000240000000000", {"585#410024000E000000"}},
                    {"605#6000000000000000", {"585#0001020304050607"}},
                    {"605#7000000000000000", {"585#1108090A0B0C0D0E"}},  // toggle, none unused, last
                    {"605#6000000000000000", {stray}},
                });
}

TEST_F(SdoBlock, AValueOfMoreThan64BytesIsReadWhereItLies) {
    verifies<req::CO_K_SDO_BUFFER, req::CO_SDO_034>();
    EXPECT_EQ(send("605#4002230000000000"), (Frames{"585#4102230048000000"}));  // 72 bytes
    EXPECT_EQ(send("605#6000000000000000"), (Frames{"585#00412076616C7565"}));  // "A value"
    EXPECT_EQ(send("605#A402230001000000"), (Frames{"585#C602230048000000"}));
    EXPECT_EQ(send("605#A300000000000000"), (Frames{"585#01412076616C7565"}));
    // and cannot be gathered anywhere
    EXPECT_EQ(send("605#2002230000000000"), (Frames{"585#8002230005000405"}));
    EXPECT_EQ(send("605#C002230000000000"), (Frames{"585#8002230005000405"}));
}

TEST_F(SdoBlock, AShortValueIsSentAsItWasWhenTheUploadBegan) {
    verifies<req::CO_SDO_021>();
    send("000#0105");  // operational
    talk(*this, {
                    {"605#A40022007F000000", {"585#C600220002000000"}},  // 2200h = 7
                    {"605#A300000000000000", {"585#8107000000000000"}},
                    {"605#A2007F0000000000", {"585#8107000000000000"}},
                    {"605#A40121017F000000", {"585#C601210102000000"}},  // 2101h:1 = 0
                    {"605#A300000000000000", {"585#8100000000000000"}},
                });
    device->objects().write(0x2101, 1, 0x1234);  // the device changes it
    EXPECT_EQ(send("605#A2007F0000000000"), (Frames{"585#8100000000000000"}));
    EXPECT_EQ(send("605#A2017F0000000000"), (Frames{"585#D500000000000000"}));  // five unused, CRC of 0000h
}

TEST_F(SdoBlock, UploadRequestsOutOfTurn) {
    verifies<req::CO_SDO_006, req::CO_SDO_018>();
    hold(nine);
    const std::string refused = "585#8000240001000405";
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    const std::string acknowledge = "605#A2027F0000000000";
    const Frames ended{"585#D5C3310000000000"};
    talk(*this, {
                    {start, {stray}},
                    {acknowledge, {stray}},
                    {"605#A100000000000000", {stray}},
                    // not started yet
                    {initiate, initiated},
                    {acknowledge, {refused}},
                    {initiate, initiated},
                    {"605#A100000000000000", {refused}},
                    {initiate, initiated},
                    {"605#6000000000000000", {refused}},
                    {initiate, initiated},
                    {"605#0011223344556677", {refused}},
                    {initiate, initiated},
                    {"605#C100000000000000", {refused}},
                    // segments are out
                    {initiate, initiated},
                    {start, segments},
                    {start, {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A100000000000000", {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#7000000000000000", {refused}},
                    // the end is out
                    {initiate, initiated},
                    {start, segments},
                    {acknowledge, ended},
                    {acknowledge, {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {acknowledge, ended},
                    {start, {refused}},
                });
}

TEST_F(SdoBlock, ADownloadSegmentAfterABlockUploadInitiateWritesNothing) {
    verifies<req::CO_SDO_006, req::CO_SDO_011>();
    talk(*this, {
                    {"605#A40010007F000000", {"585#C600100004000000"}},  // 1000h is read-only
                    {"605#09FFFFFFFF000000", {"585#8000100001000405"}},
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    {"605#4008100000000000", {"585#4108100011000000"}},  // the same with a plain upload, 17 bytes
                    {"605#01FFFFFFFFFFFFFF", {"585#8008100001000405"}},
                    {"605#4008100000000000", {"585#4108100011000000"}},
                    {"605#6000000000000000", {"585#00436F6E666F726D"}},  // "Conform"
                });
}

TEST_F(SdoBlock, TheClientsAbortEndsAnUploadInEveryState) {
    verifies<req::CO_SDO_013>();
    hold(nine);
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    const std::string abort = "605#8000240000000008";
    talk(*this, {
                    {initiate, initiated},
                    {abort, {}},
                    {start, {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {abort, {}},
                    {"605#A2027F0000000000", {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},
                    {abort, {}},
                    {"605#A100000000000000", {stray}},
                });
}

TEST_F(SdoBlock, ANewInitiateEndsAnUploadInEveryState) {
    verifies<req::CO_SDO_012>();
    hold(nine);
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    talk(*this, {
                    {initiate, initiated},
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    {start, {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#2F01220008000000", {"585#6001220000000000"}},
                    {"605#A2027F0000000000", {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#8000240000000008", {}},
                    {initiate, initiated},
                    {"605#A40010007F000000", {"585#C600100004000000"}},
                    {start, {"585#8178563412000000"}},
                });
}

TEST_F(SdoBlock, AStalledUploadIsAbortedInEveryState) {
    verifies<req::CO_SDO_014>();
    hold(nine);
    const Frames timed_out{"1:585#8000240000000405"};
    send("605#A40024007F000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    send("605#A40024007F000000");
    pass(500);
    send("605#A300000000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    send("605#A40024007F000000");
    send("605#A300000000000000");
    pass(500);
    send("605#A2027F0000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    EXPECT_TRUE(pass(5000).empty());
}

// -- download ---------------------------------------------------------------------------------------------------------

TEST_F(SdoBlock, DownloadOfNineBytes) {
    verifies<req::CO_SDO_026, req::CO_SDO_029, req::CO_SDO_033>();
    hold({0xAA});
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                });
    EXPECT_EQ(held(), Bytes{0xAA});  // not before the end
    talk(*this, {
                    {"605#D5C3310000000000", {"585#A100000000000000"}},  // five unused, 31C3h
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, DownloadWithoutSize) {
    verifies<req::CO_SDO_029>();
    talk(*this, {
                    {"605#C400240000000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5C3310000000000", {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, TheCrcIsNotLookedAtWhenTheClientHasNone) {
    verifies<req::CO_SDO_028>();
    talk(*this, {
                    {"605#C200240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {"605#D5FFFF0000000000", {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), nine);
}

TEST_F(SdoBlock, AWrongCrcRefusesTheWhole) {
    verifies<req::CO_SDO_028, req::CO_SDO_033, req::CO_E_ABORT>();
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

TEST_F(SdoBlock, WhatTheServerDidNotGetIsAskedForAgain) {
    verifies<req::CO_SDO_026>();
    const Bytes bytes = counting(28);
    const std::string crc = block_end("605", bytes);
    talk(*this, {
                    {"605#C60024001C000000", {"585#A40024007F000000"}},
                    {"605#0101020304050607", {}},
                    {"605#030F101112131415", {}},  // the second was lost
                    {"605#84161718191A1B1C", {"585#A2017F0000000000"}},
                    {"605#0108090A0B0C0D0E", {}},                        // it becomes number 1
                    {"605#83161718191A1B1C", {"585#A2017F0000000000"}},  // now the next one was lost
                    {"605#82161718191A1B1C", {"585#A2007F0000000000"}},  // and again
                    {"605#010F101112131415", {}},
                    {"605#82161718191A1B1C", {"585#A2027F0000000000"}},
                    {crc, {"585#A100000000000000"}},
                });
    EXPECT_EQ(held(), bytes);
}

TEST_F(SdoBlock, ASegmentThatComesTwiceCountsOnce) {
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

TEST_F(SdoBlock, AFullSubBlockIsAcknowledgedAtItsEnd) {
    verifies<req::CO_SDO_026, req::CO_K_SDO_BLOCK_SIZE>();
    const Bytes bytes = counting(7 * 127 + 5, 3);
    send("605#C60024007E030000");  // 894 = 37Eh
    for (unsigned sequence = 1; sequence < 127; ++sequence) {
        ASSERT_TRUE(send(block_segment("605", sequence, bytes, (sequence - 1) * std::size_t{7})).empty());
    }
    EXPECT_EQ(send(block_segment("605", 127, bytes, 126 * 7)), (Frames{"585#A27F7F0000000000"}));
    EXPECT_EQ(send(block_segment("605", 1, bytes, 127 * 7)), (Frames{"585#A2017F0000000000"}));
    EXPECT_EQ(send(block_end("605", bytes)), (Frames{"585#A100000000000000"}));
    EXPECT_EQ(held(), bytes);
}

TEST_F(SdoBlock, AnEmptyValueCanBeDownloaded) {
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

TEST_F(SdoBlock, OrdinaryEntriesTakeBlocksUnderTheSameChecks) {
    verifies<req::CO_SDO_029, req::CO_SDO_010, req::CO_SDO_011, req::CO_E_ABORT>();
    const auto block_of = [](const std::string& object, const Bytes& bytes, const std::string& last) {
        return std::vector<Exchange>{
            {"605#C4" + object + "00000000", {"585#A4" + object + "7F000000"}},
            {block_segment("605", 1, bytes, 0), {"585#A2017F0000000000"}},
            {block_end("605", bytes), {last}},
        };
    };
    const std::string done = "585#A100000000000000";
    talk(*this, block_of("002200", {0x64, 0x00}, done));                          // 100
    talk(*this, block_of("002200", {0x65, 0x00}, "585#8000220031000906"));        // 101, above its limit
    talk(*this, block_of("002200", {0x9B, 0xFF}, "585#8000220032000906"));        // −101, below
    talk(*this, block_of("002200", {0x01}, "585#8000220013000706"));              // too short
    talk(*this, block_of("002200", {0x01, 0x00, 0x00}, "585#8000220012000706"));  // too long
    talk(*this, {{"605#4000220000000000", {"585#4B00220064000000"}}});            // still 100
    talk(*this, block_of("012200", {5}, "585#8001220030000906"));                 // 2 and 8 only
    talk(*this, block_of("002300", {'x', 'y', 'z', 'z', 'y'}, done));             // a string may be shorter
    talk(*this, {{"605#4000230000000000", {"585#4100230005000000"}}});
    talk(*this, block_of("101001", {'s', 'a', 'v', 'x'}, "585#8010100120000008"));  // no signature
}

TEST_F(SdoBlock, WhatCannotBeWrittenIsRefusedAtOnce) {
    verifies<req::CO_SDO_008, req::CO_SDO_009, req::CO_SDO_010, req::CO_SDO_034>();
    talk(*this, {
                    {"605#C600100004000000", {"585#8000100002000106"}},
                    {"605#C602240004000000", {"585#8002240002000106"}},  // a DOMAIN to read
                    {"605#C634120004000000", {"585#8034120000000206"}},
                    {"605#C600220104000000", {"585#8000220111000906"}},
                    {"605#C600220003000000", {"585#8000220012000706"}},  // three bytes for an INTEGER16
                    {"605#C600240001000100", {"585#8000240012000706"}},  // 65,537 bytes
                    {"605#C6002400FFFFFFFF", {"585#8000240012000706"}},
                    {"605#C601240004000000", {"585#8001240005000405"}},  // no memory to gather in
                    {"605#0131323334353637", {stray}},
                });
}

TEST_F(SdoBlock, AnotherLengthThanAnnouncedIsRefused) {
    verifies<req::CO_SDO_010, req::CO_SDO_033, req::CO_E_ABORT>();
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

TEST_F(SdoBlock, MoreThanTheEntryHoldsIsRefusedWhileItComes) {
    verifies<req::CO_SDO_010>();
    // 2300h holds 40 bytes: five segments are 35, a sixth may be its last with 2 unused, a seventh is too much
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

TEST_F(SdoBlock, PairsOf1And127CannotRunOutOfTheMemory) {
    verifies<req::CO_SDO_010, req::CO_SDO_026>();
    // each pair ends a sub-block of which one segment was in order
    talk(*this, {{"605#C400230000000000", {"585#A40023007F000000"}}});
    for (int pair = 0; pair < 6; ++pair) {
        talk(*this, {{"605#0141414141414141", {}}, {"605#7F42424242424242", {"585#A2017F0000000000"}}});
    }
    talk(*this, {
                    {"605#0141414141414141", {"585#8000230012000706"}},
                    {"605#4000230000000000", {"585#4700230061626300"}},
                });
    // the same on 64 KiB: 9,363 pairs are 65,541 bytes
    ASSERT_EQ(send("605#C400240000000000"), (Frames{"585#A40024007F000000"}));
    for (int pair = 0; pair < 9363; ++pair) {
        ASSERT_TRUE(send("605#0141414141414141").empty());
        ASSERT_EQ(send("605#7F42424242424242"), (Frames{"585#A2017F0000000000"}));
    }
    EXPECT_EQ(send("605#0141414141414141"), (Frames{"585#8000240012000706"}));
    EXPECT_EQ(device->held(program_index, 0).size(), 0U);
}

TEST_F(SdoBlock, SequenceNumberZero) {
    verifies<req::CO_SDO_027, req::CO_SDO_030, req::CO_E_ABORT>();
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0031323334353637", {"585#8000240003000405"}},
                    {"605#0131323334353637", {stray}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#8000240000000008", {}},  // 80h: the client's abort
                    {"605#0131323334353637", {stray}},
                });
}

TEST_F(SdoBlock, WhileSegmentsArriveEveryRequestIsOne) {
    verifies<req::CO_SDO_030, req::CO_SDO_012>();
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"605#4000100000000000", {}},                        // number 64, out of order
                    {"605#2F01220008000000", {}},                        // number 47
                    {"605#C600240009000000", {"585#A2017F0000000000"}},  // number 70, marked as the last
                    {"605#8138390000000000", {"585#A2017F0000000000"}},
                    // the last one is in: from here on an initiate is an initiate
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_TRUE(held().empty());
}

TEST_F(SdoBlock, DownloadRequestsOutOfTurn) {
    verifies<req::CO_SDO_006, req::CO_SDO_018>();
    const std::string refused = "585#8000240001000405";
    const std::vector<Exchange> received{
        {"605#C600240009000000", {"585#A40024007F000000"}},
        {"605#0131323334353637", {}},
        {"605#8238390000000000", {"585#A2027F0000000000"}},
    };
    talk(*this, {{"605#C100000000000000", {stray}}, {"605#0131323334353637", {stray}}});
    for (const std::string wrong : {"605#0338390000000000", "605#6000000000000000", "605#A300000000000000",
                                    "605#A2027F0000000000", "605#A100000000000000"}) {
        talk(*this, received);
        talk(*this, {{wrong, {refused}}, {"605#D5C3310000000000", {stray}}});
    }
    EXPECT_TRUE(held().empty());
}

TEST_F(SdoBlock, TheClientsAbortEndsADownloadInEveryState) {
    verifies<req::CO_SDO_013, req::CO_SDO_033>();
    hold({7});
    const std::string initiate = "605#C600240009000000";
    const Frames initiated{"585#A40024007F000000"};
    const std::string abort = "605#8000240000000008";
    talk(*this, {
                    {initiate, initiated},
                    {abort, {}},
                    {initiate, initiated},
                    {"605#0131323334353637", {}},
                    {abort, {}},
                    {initiate, initiated},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {abort, {}},
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_EQ(held(), Bytes{7});
}

TEST_F(SdoBlock, AStalledDownloadIsAborted) {
    verifies<req::CO_SDO_014, req::CO_SDO_033, req::CO_SDO_037>();
    hold({7});
    const Frames timed_out{"1:585#8000240000000405"};
    send("605#C600240009000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    // the segment marked as the last is lost: neither side can know
    send("605#C600240009000000");
    pass(900);
    send("605#0131323334353637");
    EXPECT_TRUE(pass(999).empty());  // a segment starts the time-out anew
    EXPECT_EQ(pass(1), timed_out);
    send("605#C600240009000000");
    send("605#0131323334353637");
    send("605#8238390000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    EXPECT_EQ(held(), Bytes{7});
}

TEST_F(SdoBlock, TheDeviceMayRefuseTheWhole) {
    verifies<req::CO_SDO_033>();
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

TEST_F(SdoBlock, ADomainTakesExpeditedAndSegmentedDownloadsToo) {
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
    talk(*this, {{"605#2301240001020304", {"585#8001240005000405"}},    // no memory
                 {"605#2302240001020304", {"585#8002240002000106"}}});  // read-only
}

TEST_F(SdoBlock, StoppedAndResetForgetABlockTransfer) {
    verifies<req::CO_SDO_017, req::CO_SDO_033>();
    hold({7});
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"000#0205", {}},
                    {"605#8238390000000000", {}},
                    {"000#8005", {}},
                    {"605#8238390000000000", {}},  // ccs 4: an abort, of nothing
                    {"605#D5C3310000000000", {stray}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"000#8205", {"705#00"}},
                    {"605#0238390000000000", {stray}},
                });
    EXPECT_EQ(held(), Bytes{7});
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
                    // one that comes during a transfer ends it
                    {"603#4008100000000000", {"583#410810000D000000"}},
                    {"603#A300000000000000", {"583#8008100001000405"}},
                    {"603#6000000000000000", {refused}},
                });
}

}  // namespace canproof::test
