// SPDX-License-Identifier: Apache-2.0
// Checks every object of the CAN-CBX-AO412 against chapter 7 of its manual: default, length, access, limits. Node 3.
#include <fmt/format.h>

#include <algorithm>

#include "generated/cbx_ao412/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Row {
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t value;  ///< default at node 3
    int bytes;
    bool writable;
};

// The entries of sections 7.9.1 to 7.12.2, written by hand.
const std::vector<Row> rows{
    {0x1000, 0, 0x00080191, 4, false}, {0x1001, 0, 0, 1, false},          {0x1002, 0, 0, 4, false},
    {0x1003, 0, 0, 1, true},           {0x1003, 1, 0, 4, false},          {0x1003, 10, 0, 4, false},
    {0x1005, 0, 0x80, 4, true},        {0x1006, 0, 0, 4, true},           {0x100C, 0, 0, 2, true},
    {0x100D, 0, 0, 1, true},           {0x100E, 0, 0x703, 4, true},       {0x1010, 0, 4, 1, false},
    {0x1010, 1, 1, 4, true},           {0x1010, 4, 1, 4, true},           {0x1011, 0, 4, 1, false},
    {0x1011, 1, 1, 4, true},           {0x1011, 4, 1, 4, true},           {0x1014, 0, 0x83, 4, true},
    {0x1015, 0, 0, 2, true},           {0x1016, 0, 1, 1, false},          {0x1016, 1, 0, 4, true},
    {0x1017, 0, 0, 2, true},           {0x1018, 0, 4, 1, false},          {0x1018, 1, 0x17, 4, false},
    {0x1018, 2, 0x23040002, 4, false}, {0x1018, 3, 0x00020004, 4, false}, {0x1018, 4, 0xC1C20105, 4, false},
    {0x1019, 0, 0, 1, true},           {0x1020, 0, 2, 1, false},          {0x1020, 1, 0, 4, true},
    {0x1020, 2, 0, 4, true},           {0x1029, 0, 1, 1, false},          {0x1029, 1, 0, 1, true},
    {0x1401, 0, 2, 1, false},          {0x1401, 1, 0x303, 4, true},       {0x1401, 2, 0xFF, 1, true},
    {0x1402, 0, 2, 1, false},          {0x1402, 1, 0x403, 4, true},       {0x1402, 2, 0xFF, 1, true},
    {0x1601, 0, 4, 1, true},           {0x1601, 1, 0x64110110, 4, true},  {0x1601, 2, 0x64110210, 4, true},
    {0x1601, 3, 0x64110310, 4, true},  {0x1601, 4, 0x64110410, 4, true},  {0x1602, 0, 4, 1, true},
    {0x1602, 1, 0x00030010, 4, true},  {0x1602, 4, 0x00030010, 4, true},  {0x1F51, 0, 1, 1, false},
    {0x1F51, 1, 0, 1, true},           {0x1F52, 0, 2, 1, false},          {0x1F80, 0, 2, 4, true},
    {0x1F91, 0, 1, 1, false},          {0x1F91, 1, 100, 2, true},         {0x2404, 0, 4, 1, false},
    {0x2404, 1, 0, 2, true},           {0x2404, 4, 0, 2, true},           {0x2405, 0, 4, 1, false},
    {0x2405, 1, 0, 2, true},           {0x2405, 4, 0, 2, true},           {0x6411, 0, 4, 1, false},
    {0x6411, 1, 0, 2, true},           {0x6411, 4, 0, 2, true},           {0x6443, 0, 4, 1, false},
    {0x6443, 1, 1, 1, true},           {0x6443, 4, 1, 1, true},           {0x6444, 0, 4, 1, false},
    {0x6444, 1, 0, 4, true},           {0x6444, 4, 0, 4, true},
};

std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += fmt::format("{:02X}", (value >> (8 * i)) & 0xFFU);
    }
    return text;
}

std::string address(const Row& row) {
    return little_endian(row.index, 2) + little_endian(row.sub, 1);
}

using CbxDictionary = CbxTest;

}  // namespace

TEST_F(CbxDictionary, EntriesHaveTheirDefaultsAndLengths) {
    verifies<req::AO4_OD_1000, req::AO4_OD_1001, req::AO4_OD_1002, req::AO4_OD_1003, req::AO4_OD_1005, req::AO4_OD_1006,
             req::AO4_OD_100C, req::AO4_OD_100D, req::AO4_OD_100E, req::AO4_OD_1010, req::AO4_OD_1011, req::AO4_OD_1014,
             req::AO4_OD_1015, req::AO4_OD_1016, req::AO4_OD_1017, req::AO4_OD_1018, req::AO4_OD_1019, req::AO4_OD_1020,
             req::AO4_OD_1029>();
    verifies<req::AO4_OD_1401, req::AO4_OD_1402, req::AO4_OD_1601, req::AO4_OD_1602, req::AO4_OD_1F51, req::AO4_OD_1F52,
             req::AO4_OD_1F80, req::AO4_OD_1F91, req::AO4_OD_2404, req::AO4_OD_2405, req::AO4_OD_6411, req::AO4_OD_6443,
             req::AO4_OD_6444>();
    const std::vector<std::string> specifier{"", "4F", "4B", "", "43"};
    for (const auto& row : rows) {
        const std::string data =
            little_endian(row.value, row.bytes) + std::string(static_cast<std::size_t>(8 - 2 * row.bytes), '0');
        EXPECT_EQ(send("603#40" + address(row) + "00000000"),
                  (Frames{"583#" + specifier[static_cast<std::size_t>(row.bytes)] + address(row) + data}));
    }
}

TEST_F(CbxDictionary, ReadOnlyEntriesRefuseWrites) {
    verifies<req::AO4_OD_1000, req::AO4_OD_1001, req::AO4_OD_1002, req::AO4_OD_1018>();
    const std::vector<std::string> specifier{"", "2F", "2B", "", "23"};
    for (const auto& row : rows) {
        const std::string request = "603#" + specifier[static_cast<std::size_t>(row.bytes)] + address(row) + "00000000";
        const std::string answer = send(request).at(0);
        const bool refused_as_read_only = answer == "583#80" + address(row) + "02000106";
        EXPECT_EQ(refused_as_read_only, !row.writable) << request << " " << answer;
    }
}

TEST_F(CbxDictionary, DictionaryHasTheNumberOfObjectsOfTheManual) {
    verifies<req::AO4_OD_1000>();
    std::size_t found = 0;
    for (std::uint32_t index = 0x1000; index <= 0xFFFF; ++index) {
        const Frames answer = send(fmt::format("603#40{}00000000", little_endian(index, 2) + "00"));
        found += answer.at(0).substr(12) == "00000206" ? 0 : 1;
    }
    // Section 7.9 has 22 objects (1000h-1003h, 1005h, 1006h, 1008h-100Ah, 100Ch-100Eh, 1010h, 1011h, 1014h-1020h,
    // 1029h), 4 PDO objects, 1F80h and 1F91h. Section 7.10 has 3 objects, 7.11 has 2, 7.12 has 3.
    EXPECT_EQ(found, 4U + 2U + 3U + 3U + 2U + 7U + 1U + 4U + 2U + 3U + 2U + 3U);
}

TEST_F(CbxDictionary, SubIndicesBeyondThoseOfTheManualAreAbsent) {
    verifies<req::AO4_OD_1020, req::AO4_OD_1401, req::AO4_OD_1601, req::AO4_OD_2405>();
    const std::vector<std::pair<std::uint16_t, int>> highest{
        {0x1003, 10}, {0x1010, 4}, {0x1011, 4}, {0x1016, 1}, {0x1018, 4}, {0x1020, 2}, {0x1029, 1},
        {0x1401, 2},  {0x1402, 2}, {0x1601, 4}, {0x1602, 4}, {0x1F51, 1}, {0x1F52, 2}, {0x1F91, 1},
        {0x2404, 4},  {0x2405, 4}, {0x6411, 4}, {0x6443, 4}, {0x6444, 4}};
    for (const auto& [index, sub] : highest) {
        const auto read = [&, i = index](int at) {
            return send("603#40" + little_endian(i, 2) + little_endian(static_cast<std::uint32_t>(at), 1) + "00000000")
                .at(0)
                .substr(4, 2);
        };
        EXPECT_NE(read(sub), "80") << std::hex << index;
        EXPECT_EQ(read(sub + 1), "80") << std::hex << index;
    }
}

TEST_F(CbxDictionary, StringsMatchTheManual) {
    verifies<req::AO4_OD_1008, req::AO4_OD_1009, req::AO4_OD_100A>();
    EXPECT_EQ(send("603#4008100000000000"), (Frames{"583#410810000D000000"}));
    EXPECT_EQ(send("603#4009100000000000"), (Frames{"583#43091000312E3030"}));  // "1.00"
    EXPECT_EQ(send("603#400A100000000000"), (Frames{"583#430A1000322E3034"}));  // "2.04"
}

TEST_F(CbxDictionary, FactoryDataGiveTheUnitItsVersionsAndDate) {
    verifies<req::AO4_OD_1009, req::AO4_OD_100A, req::AO4_OD_1018, req::AO4_OD_1F52>();
    factory.hardware_version = {'1', '.', '1', '0'};
    factory.software_version = {'2', '.', '0', '6', ' ', 'b', 'e', 't'};
    factory.revision = 0x00020006;
    factory.software_date = 11286;    // 2C16h
    factory.software_time = 3600000;  // 36EE80h
    power_on();
    EXPECT_EQ(send("603#4009100000000000"), (Frames{"583#43091000312E3130"}));  // "1.10"
    EXPECT_EQ(send("603#400A100000000000"), (Frames{"583#410A100008000000"}));
    EXPECT_EQ(send("603#6000000000000000"), (Frames{"583#00322E3036206265"}));
    EXPECT_EQ(send("603#7000000000000000"), (Frames{"583#1D74000000000000"}));
    EXPECT_EQ(send("603#4018100300000000"), (Frames{"583#4318100306000200"}));
    EXPECT_EQ(send("603#40521F0100000000"), (Frames{"583#43521F01162C0000"}));
    EXPECT_EQ(send("603#40521F0200000000"), (Frames{"583#43521F0280EE3600"}));
}

TEST_F(CbxDictionary, HardwareVersionMayHaveOneCharacter) {
    verifies<req::AO4_OD_1009, req::AO4_OD_100A>();
    factory.hardware_version = {'7'};
    power_on();
    EXPECT_EQ(send("603#4009100000000000"), (Frames{"583#4F09100037000000"}));
    EXPECT_EQ(send("603#400A100000000000"), (Frames{"583#430A1000322E3034"}));  // "2.04", the default
}

TEST_F(CbxDictionary, LimitsOfTheManualAreEnforced) {
    verifies<req::AO4_OD_1016, req::AO4_OD_1029, req::AO4_OD_1601, req::AO4_OD_1F51, req::AO4_OD_6443>();
    write("603#23161001FFFF7F00");
    EXPECT_EQ(send("603#2316100100008000"), (Frames{"583#8016100130000906"}));
    write("603#2F29100102000000");
    EXPECT_EQ(send("603#2F29100103000000"), (Frames{"583#8029100130000906"}));
    write("603#2F43640102000000");
    EXPECT_EQ(send("603#2F43640103000000"), (Frames{"583#8043640130000906"}));
    EXPECT_EQ(send("603#2F01160005000000"), (Frames{"583#8001160030000906"}));
}

TEST_F(CbxDictionary, EntriesWithoutALimitInTheManualAcceptTheFullRangeOfTheirType) {
    verifies<req::AO4_OD_1006, req::AO4_OD_100C, req::AO4_OD_100D, req::AO4_OD_1015, req::AO4_OD_1017, req::AO4_OD_1020,
             req::AO4_OD_6444>();
    for (const char* request :
         {"2306100001000000", "23061000FFFFFFFF", "2B0C1000FFFF0000", "2F0D1000FF000000", "2B151000FFFF0000",
          "2B171000FFFF0000", "23201001FFFFFFFF", "2344640100000080", "23446401FFFFFF7F", "2B11640100800000",
          "2B116401FF7F0000", "2B04240100800000", "2B052401FF7F0000"}) {
        write(std::string{"603#"} + request);
    }
}

TEST_F(CbxDictionary, OnlyAnalogueOutput6411hIsMappable) {
    verifies<req::AO4_OD_6411>();
    write("603#2301140103030080");
    write("603#2F01160000000000");
    for (const auto& row : rows) {
        const std::uint32_t entry = (std::uint32_t{row.index} << 16U) | (std::uint32_t{row.sub} << 8U) |
                                    static_cast<std::uint32_t>(row.bytes * 8);
        const bool taken = send("603#23011601" + little_endian(entry, 4)).at(0).substr(4, 2) == "60";
        EXPECT_EQ(taken, row.index == 0x6411 && row.sub > 0) << std::hex << entry;
    }
}

}  // namespace canproof::test
