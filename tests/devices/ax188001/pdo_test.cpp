// SPDX-License-Identifier: Apache-2.0
// Tests the PDOs of the AX188001 (manual, 3.2.14, 3.2.15).
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Pdos = TcsTest;

}  // namespace

TEST_F(Ax188001Pdos, Tpdo1IsSentEverySecond) {
    verifies<req::TCS_PDO_001, req::TCS_OD_1800, req::TCS_OD_1A00>();
    EXPECT_EQ(read(0x1800, 1).value, 0x400001FFU);
    const std::vector<std::uint32_t> mapped{2, 0x71300110, 0x71300210, 0, 0};
    for (int sub = 0; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1A00, sub).value, mapped[static_cast<std::size_t>(sub)]) << sub;
    }
    heat(1, 100.0);
    heat(2, -15.0);
    read_once();
    EXPECT_EQ(pass(3000), Frames{});
    // The process value of 100 degC is 5968 = 1750h, that of -15 degC is 4128 = 1020h.
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#50172010"}));
    EXPECT_EQ(pass(2500), (Frames{"1000:1FF#50172010", "2000:1FF#50172010"}));
    EXPECT_EQ(send("1FF#R"), Frames{});  // bit 30 of the COB-ID is set: no answer to RTR
}

TEST_F(Ax188001Pdos, ReservedValuesAreSentInTpdo1) {
    verifies<req::TCS_PDO_001, req::TCS_VAL_005, req::TCS_VAL_006>();
    write(0x6112, 2, 1, 0);
    cut(1);
    settle();
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#00FEFFFF"}));
}

TEST_F(Ax188001Pdos, Tpdo2CarriesAverageAndColdJunctionWhenMadeValid) {
    verifies<req::TCS_PDO_002, req::TCS_PDO_007, req::TCS_OD_1801, req::TCS_OD_1A01, req::TCS_OD_2130,
             req::TCS_OD_3130>();
    EXPECT_EQ(read(0x1801, 1).value, 0xC00002FFU);
    EXPECT_EQ(read(0x1801, 5).value, 0U);
    const std::vector<std::uint32_t> mapped{2, 0x21300010, 0x31300010, 0, 0};
    for (int sub = 0; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1A01, sub).value, mapped[static_cast<std::size_t>(sub)]) << sub;
    }
    EXPECT_EQ(write(0x1801, 5, 2, 700), 0U);
    EXPECT_EQ(write(0x1801, 1, 4, 0x400002FF), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    heat(1, 75.0);
    heat(2, 25.0);
    inputs.cold_junction = 25.0F;
    set_inputs();
    read_once();
    // The process value of 50 degC is 5168 = 1430h, that of 25 degC is 4768 = 12A0h.
    EXPECT_EQ(send("000#0100"), (Frames{"2FF#3014A012"}));
    EXPECT_EQ(pass(1400), (Frames{"700:2FF#3014A012", "1400:2FF#3014A012"}));
}

TEST_F(Ax188001Pdos, Tpdo3And4AreEmpty) {
    verifies<req::TCS_PDO_003, req::TCS_OD_1802, req::TCS_OD_1803, req::TCS_OD_1A02, req::TCS_OD_1A03>();
    for (const int n : {2, 3}) {
        EXPECT_EQ(read(0x1800 + n, 1).value, 0xC00001FFU + static_cast<std::uint32_t>(n) * 0x100U);
        EXPECT_EQ(read(0x1800 + n, 5).value, 0U);
        for (int sub = 0; sub <= 4; ++sub) {
            EXPECT_EQ(read(0x1A00 + n, sub).value, 0U);
        }
    }
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#A012A012"}));
}

TEST_F(Ax188001Pdos, TpdosAreRemappedInFiveSteps) {
    verifies<req::TCS_PDO_004, req::TCS_OD_1A02, req::TCS_OD_6100, req::TCS_OD_6150, req::TCS_OD_5040>();
    EXPECT_EQ(write(0x1802, 1, 4, 0xC00003FF), 0U);
    EXPECT_EQ(write(0x1A02, 0, 1, 0), 0U);
    EXPECT_EQ(write(0x1A02, 1, 4, 0x50400220), 0U);  // maps 5040h:2 (FD Field Value), the supply voltage as REAL32
    EXPECT_EQ(write(0x1A02, 2, 4, 0x61500108), 0U);
    EXPECT_EQ(write(0x1A02, 3, 4, 0x61500208), 0U);
    EXPECT_EQ(write(0x1A02, 4, 4, 0x71300110), 0U);
    EXPECT_EQ(write(0x1A02, 0, 1, 4), 0U);
    EXPECT_EQ(write(0x1802, 5, 2, 100), 0U);
    EXPECT_EQ(write(0x1802, 1, 4, 0x400003FF), 0U);
    // TPDO3 is valid now, so its mapping cannot change
    EXPECT_EQ(write(0x1A02, 0, 1, 0), 0x08000022U);
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#A012A012", "3FF#000070430000A012"}));  // 240.0F is 43700000h
}

TEST_F(Ax188001Pdos, OnlyMeasuredValuesCanBeMapped) {
    verifies<req::TCS_OD_2010, req::TCS_OD_4000, req::TCS_OD_5040, req::TCS_OD_2100, req::TCS_OD_3100>();
    EXPECT_EQ(write(0x1A03, 1, 4, 0x21000020), 0U);
    EXPECT_EQ(write(0x1A03, 1, 4, 0x31000020), 0U);
    for (const std::uint32_t entry : {0x20100120U, 0x40000110U, 0x50400008U, 0x61120108U, 0x21120008U, 0x61100110U}) {
        EXPECT_EQ(write(0x1A03, 1, 4, entry), 0x06040041U) << fmt::format("{:08X}", entry);
    }
    // refused, although the manual prints this mapping entry for TPDO4: 2130h:3 does not exist
    EXPECT_EQ(write(0x1A03, 1, 4, 0x21300310), no_subindex);
    EXPECT_EQ(write(0x1A03, 1, 4, 0x71300310), no_subindex);
}

TEST_F(Ax188001Pdos, RpdosExistAndMapNothing) {
    verifies<req::TCS_PDO_005, req::TCS_PDO_006, req::TCS_PDO_008, req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402,
             req::TCS_OD_1403, req::TCS_OD_1600, req::TCS_OD_1601, req::TCS_OD_1602, req::TCS_OD_1603>();
    for (int n = 0; n < 4; ++n) {
        EXPECT_EQ(read(0x1400 + n, 0).value, 5U);
        EXPECT_EQ(read(0x1400 + n, 1).value, 0xC000027FU + static_cast<std::uint32_t>(n) * 0x100U);
        EXPECT_EQ(read(0x1400 + n, 2).value, 255U);
        for (int sub = 3; sub <= 5; ++sub) {
            EXPECT_EQ(read(0x1400 + n, sub).value, 0U);
            EXPECT_EQ(read(0x1400 + n, sub).size, sub == 4 ? 1 : 2);
        }
        for (int sub = 0; sub <= 4; ++sub) {
            EXPECT_EQ(read(0x1600 + n, sub).value, 0U);
            EXPECT_EQ(write(0x1600 + n, sub, sub == 0 ? 1 : 4, 0), read_only);
        }
        EXPECT_EQ(read(0x1600 + n, 5).abort, no_subindex);
    }
    EXPECT_EQ(write(0x1400, 5, 2, 100), 0U);
    send("000#0100");
    EXPECT_EQ(send("27F#0102030405060708"), Frames{});
    EXPECT_EQ(pass(500), Frames{}) << "an invalid RPDO is not received, so it cannot become overdue";
    EXPECT_EQ(write(0x1400, 1, 4, 0x4000027F), 0U);
    EXPECT_EQ(send("27F#0102030405060708"), Frames{});
    EXPECT_EQ(pass(100), (Frames{"100:0FF#0081010000000000"})) << "a valid RPDO can";
}

TEST_F(Ax188001Pdos, TransmissionTypesAreReadOnlyAndAValueChangeSendsNoTpdo) {
    verifies<req::TCS_PDO_006, req::TCS_PDO_009, req::TCS_OD_1800, req::TCS_OD_1801, req::TCS_OD_1802, req::TCS_OD_1803,
             req::TCS_OD_1A00, req::TCS_OD_1A01>();
    for (int n = 0; n < 4; ++n) {
        EXPECT_EQ(read(0x1800 + n, 0).value, 5U);
        EXPECT_EQ(write(0x1800 + n, 0, 1, 5), read_only);
        EXPECT_EQ(read(0x1800 + n, 1).size, 4);
        EXPECT_EQ(read(0x1800 + n, 3).value, 0U);
        EXPECT_EQ(read(0x1800 + n, 3).size, 2);
        EXPECT_EQ(read(0x1800 + n, 4).value, 0U);
        EXPECT_EQ(read(0x1800 + n, 4).size, 1);
        EXPECT_EQ(read(0x1800 + n, 5).size, 2);
        EXPECT_EQ(read(0x1800 + n, 6).abort, no_subindex);
        EXPECT_EQ(read(0x1400 + n, 6).abort, no_subindex);
        EXPECT_EQ(read(0x1A00 + n, 5).abort, no_subindex);
        EXPECT_EQ(write(0x1A00 + n, 0, 1, 5), too_high);
        EXPECT_EQ(read(0x1800 + n, 2).value, 254U);
        EXPECT_EQ(write(0x1800 + n, 2, 1, 1), read_only);
        EXPECT_EQ(write(0x1400 + n, 2, 1, 1), read_only);
    }
    EXPECT_EQ(read(0x1800, 5).value, 1000U);
    EXPECT_EQ(write(0x1800, 5, 2, 0), 0U);
    EXPECT_EQ(send("000#0100"), Frames{});
    heat(1, 100.0);  // a changed value sends no TPDO
    EXPECT_EQ(pass(5000), Frames{});
}

}  // namespace canproof::test
