// SPDX-License-Identifier: Apache-2.0
// The PDOs of the AX060805 (manual, 3.9, 3.10), node 127.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/network_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax060805Network, Tpdo1IsSentEvery250msWithAnglesAndFigureOfMerit) {
    verifies<req::INC_PDO_002, req::INC_OD_1800, req::INC_OD_1A00>();
    turn(0.0, -20.0);
    pass(1000);
    // TPDO1 carries pitch 0, roll -20, gravity angle 20 and figure of merit 0 (good).
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#0000ECFF140000"}));
    EXPECT_EQ(pass(700), (Frames{"250:1FF#0000ECFF140000", "500:1FF#0000ECFF140000"}));
    inputs.sensor_temperature = 130.0F;
    write(0x1029, 2, 1, 1);
    set_inputs();
    const Frames later = pass(100);
    ASSERT_EQ(later.size(), 2U);
    EXPECT_EQ(later[1], "50:1FF#0000ECFF140001");
    send("000#8000");
    EXPECT_EQ(pass(1000), (Frames{}));
}

TEST_F(Ax060805Network, Tpdo2And3AreNotSentUntilTheirTimersAreSet) {
    verifies<req::INC_PDO_003, req::INC_OD_1801, req::INC_OD_1802, req::INC_OD_1A01, req::INC_OD_1A02, req::INC_PDO_010,
             req::INC_PDO_011>();
    acceleration_digits(1000);
    inputs.sensor_temperature = 21.0F;
    inputs.supply_voltage = 12.0F;
    inputs.processor_temperature = -2.5F;
    feel(0.1, -0.2, -1.0);
    pass(1000);
    write(0x1800, 5, 0, 2);
    EXPECT_EQ(send("000#0100"), (Frames{}));
    EXPECT_EQ(pass(1000), (Frames{}));
    write(0x1801, 5, 100, 2);
    // the mapped values: 100 = 0064h, -200 = FF38h, -1000 = FC18h, 21 = 0015h
    EXPECT_EQ(pass(100), (Frames{"100:2FF#640038FF18FC1500"}));
    write(0x1801, 5, 0, 2);
    write(0x1802, 5, 100, 2);
    // the mapped values: 12.0 = 41400000h, -2.5 = C0200000h
    EXPECT_EQ(pass(100), (Frames{"100:3FF#00004041000020C0"}));
}

TEST_F(Ax060805Network, Tpdo4IsInvalidAndEmpty) {
    verifies<req::INC_PDO_004, req::INC_OD_1803, req::INC_OD_1A03>();
    EXPECT_EQ(read(0x1803, 1), 0xC00004FFU);
    EXPECT_EQ(read(0x1A03, 0), 0U);
    write(0x1803, 1, 0x400001FE, 4);  // accepted, because TPDO4 is not valid before this write
    write(0x1803, 1, 0xC00004FF, 4);
    write(0x1803, 5, 50, 2);
    write(0x1800, 5, 0, 2);
    write(0x1A03, 1, 0x30000110, 4);
    write(0x1A03, 0, 1, 1);
    send("000#0100");
    EXPECT_EQ(pass(200), (Frames{})) << "invalid, with a mapping";
    write(0x1A03, 0, 0, 1);
    write(0x1803, 1, 0x400004FF, 4);
    EXPECT_EQ(pass(200), (Frames{})) << "valid, with an empty mapping";
}

TEST_F(Ax060805Network, Tpdo1And2DoNotAnswerRemoteFrames) {
    verifies<req::INC_OD_1800, req::INC_OD_1801, req::INC_PDO_002>();
    send("000#0100");
    EXPECT_EQ(send("1FF#R"), (Frames{}));
    EXPECT_EQ(send("2FF#R"), (Frames{}));
}

TEST_F(Ax060805Network, Rpdo1SetsTheThreeReceivedValues) {
    verifies<req::INC_PDO_001, req::INC_OD_1400, req::INC_OD_1600, req::INC_OD_2500, req::INC_PDO_009>();
    send("000#0100");
    send("27F#0102FEFF0080");
    EXPECT_EQ(value(0x2500, 1), 0x0201);
    EXPECT_EQ(value(0x2500, 2), -2);
    EXPECT_EQ(value(0x2500, 3), -32768);
    for (const char* other : {"37F#0909090909090909", "47F#0909090909090909", "57F#0909090909090909"}) {
        send(other);
    }
    EXPECT_EQ(value(0x2500, 1), 0x0201);
}

TEST_F(Ax060805Network, Rpdo2To4AreInvalidAndEmpty) {
    verifies<req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1601, req::INC_OD_1602, req::INC_OD_1603,
             req::INC_PDO_009>();
    const std::vector<std::uint32_t> cob_ids{0xC000037FU, 0xC000047FU, 0xC000057FU};
    for (std::uint16_t pdo = 0; pdo < 3; ++pdo) {
        EXPECT_EQ(read(static_cast<std::uint16_t>(0x1401 + pdo), 1), cob_ids[pdo]);
        EXPECT_EQ(read(static_cast<std::uint16_t>(0x1601 + pdo), 0), 0U);
        EXPECT_EQ(read(static_cast<std::uint16_t>(0x1601 + pdo), 1), 0U);
    }
}

TEST_F(Ax060805Network, TransmissionTypesCannotBeWritten) {
    verifies<req::INC_PDO_005, req::INC_OD_1400, req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1800,
             req::INC_OD_1801, req::INC_OD_1802, req::INC_OD_1803>();
    for (std::uint16_t pdo = 0; pdo < 4; ++pdo) {
        const auto receive = static_cast<std::uint16_t>(0x1400 + pdo);
        const auto transmit = static_cast<std::uint16_t>(0x1800 + pdo);
        EXPECT_EQ(read(receive, 2), 255U);
        EXPECT_EQ(read(transmit, 2), 254U);
        EXPECT_EQ(refusal(receive, 2, 1, 1), "06010002");
        EXPECT_EQ(refusal(transmit, 2, 1, 1), "06010002");
    }
}

TEST_F(Ax060805Network, PdoIsRemappedInFiveSteps) {
    verifies<req::INC_PDO_006, req::INC_OD_1601, req::INC_OD_1A03>();
    EXPECT_EQ(refusal(0x1A00, 0, 0, 1), "08000022");  // 1A00h:0 cannot be changed while TPDO1 is valid
    write(0x1803, 1, 0xC00004FF, 4);
    write(0x1A03, 0, 0, 1);
    write(0x1A03, 1, 0x40100010, 4);
    write(0x1A03, 2, 0x30000110, 4);
    write(0x1A03, 3, 0x40800020, 4);
    write(0x1A03, 0, 3, 1);
    write(0x1803, 1, 0x400004FF, 4);
    write(0x1803, 5, 30, 2);
    write(0x1800, 5, 0, 2);
    write(0x4080, 0, 0x12345678, 4);
    EXPECT_EQ(send("000#0100"), (Frames{"4FF#2000000078563412"}));  // filter latency 32 ms; the undefined result of
                                                                    // function 1 as 0; then 4080h
    write(0x1601, 1, 0x25000310, 4);
    write(0x1601, 0, 1, 1);
    write(0x1401, 1, 0x4000037F, 4);
    send("37F#2A00");
    EXPECT_EQ(value(0x2500, 3), 42);
}

TEST_F(Ax060805Network, OnlyTheObjectsNamedInTheManualCanBeMapped) {
    verifies<req::INC_PDO_007, req::INC_PDO_008, req::INC_OD_2500, req::INC_OD_3000, req::INC_OD_4000, req::INC_OD_4010,
             req::INC_OD_4020, req::INC_OD_4030, req::INC_OD_4040, req::INC_OD_4050, req::INC_OD_4060, req::INC_OD_4070,
             req::INC_OD_4080, req::INC_OD_5020, req::INC_OD_5030>();
    const std::vector<std::uint32_t> transmitted{0x30000110, 0x30000A10, 0x40000110, 0x40000310, 0x40100010,
                                                 0x40200008, 0x40300010, 0x40400010, 0x40500010, 0x40600010,
                                                 0x40700020, 0x40800020, 0x50200020, 0x50300020};
    for (const std::uint32_t entry : transmitted) {
        EXPECT_EQ(refusal(0x1A03, 1, entry, 4), "") << std::hex << entry;
        EXPECT_EQ(refusal(0x1601, 1, entry, 4), "06040041") << std::hex << entry;
    }
    EXPECT_EQ(refusal(0x1601, 1, 0x25000110, 4), "");
    EXPECT_EQ(refusal(0x1A03, 1, 0x25000110, 4), "06040041");
    for (const std::uint32_t entry : {0x10010008U, 0x20000008U, 0x20030008U, 0x20100110U, 0x22000020U, 0x23000008U,
                                      0x24000020U, 0x25010110U, 0x300A0108U, 0x30100108U, 0x55550001U, 0x40000008U}) {
        EXPECT_EQ(refusal(0x1A03, 1, entry, 4), "06040041") << std::hex << entry;
        EXPECT_EQ(refusal(0x1601, 1, entry, 4), "06040041") << std::hex << entry;
    }
}

}  // namespace canproof::test
