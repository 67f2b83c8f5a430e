// SPDX-License-Identifier: Apache-2.0
// Tests the dictionary of the AX188001 (manual, 3.2, 3.3, 3.4): reads it entry by entry, as an SDO client does.
#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Ax188001Dictionary = TcsTest;

}  // namespace

TEST_F(Ax188001Dictionary, DictionaryHasExactlyTheObjectsOfTheThreeTablesOfTheManual) {
    verifies<req::TCS_OD_001>();
    const std::vector<int> objects{0x1000, 0x1001, 0x1002, 0x1003, 0x100C, 0x100D, 0x1010, 0x1011, 0x1016, 0x1017,
                                   0x1018, 0x1020, 0x1029, 0x1400, 0x1401, 0x1402, 0x1403, 0x1600, 0x1601, 0x1602,
                                   0x1603, 0x1800, 0x1801, 0x1802, 0x1803, 0x1A00, 0x1A01, 0x1A02, 0x1A03, 0x2000,
                                   0x2010, 0x2020, 0x2100, 0x2112, 0x2126, 0x2127, 0x2130, 0x3100, 0x3126, 0x3127,
                                   0x3130, 0x4000, 0x4010, 0x4020, 0x4030, 0x5040, 0x5041, 0x5042, 0x5050, 0x5051,
                                   0x5555, 0x5556, 0x6100, 0x6110, 0x6112, 0x6126, 0x6127, 0x6150, 0x7130};
    std::vector<int> found;
    for (int index = 0x1000; index <= 0xFFFF; ++index) {
        if (read(index, 0).abort != no_object) {
            found.push_back(index);
        }
    }
    EXPECT_EQ(found, objects);
}

TEST_F(Ax188001Dictionary, EachEntryHasTheLengthOfItsType) {
    verifies<req::TCS_OD_1000, req::TCS_OD_1001, req::TCS_OD_1002, req::TCS_OD_1003, req::TCS_OD_100C, req::TCS_OD_100D,
             req::TCS_OD_1010, req::TCS_OD_1011, req::TCS_OD_1016, req::TCS_OD_1017, req::TCS_OD_1018, req::TCS_OD_1020,
             req::TCS_OD_1029, req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402, req::TCS_OD_1403, req::TCS_OD_1600,
             req::TCS_OD_1601, req::TCS_OD_1602, req::TCS_OD_1603, req::TCS_OD_1800, req::TCS_OD_1801, req::TCS_OD_1802,
             req::TCS_OD_1803, req::TCS_OD_1A00, req::TCS_OD_1A01, req::TCS_OD_1A02, req::TCS_OD_1A03, req::TCS_OD_2000,
             req::TCS_OD_2010, req::TCS_OD_2020, req::TCS_OD_2100, req::TCS_OD_2112, req::TCS_OD_2126, req::TCS_OD_2127,
             req::TCS_OD_2130, req::TCS_OD_3100, req::TCS_OD_3126, req::TCS_OD_3127, req::TCS_OD_3130, req::TCS_OD_4000,
             req::TCS_OD_4010, req::TCS_OD_4020, req::TCS_OD_4030, req::TCS_OD_5040, req::TCS_OD_5041, req::TCS_OD_5042,
             req::TCS_OD_5050, req::TCS_OD_5051, req::TCS_OD_5555, req::TCS_OD_5556, req::TCS_OD_6100, req::TCS_OD_6110,
             req::TCS_OD_6112, req::TCS_OD_6126, req::TCS_OD_6127, req::TCS_OD_6150, req::TCS_OD_7130>();
    struct Object {
        int index;
        std::vector<int> bytes;  // length in bytes of sub-index 0, 1, …
    };
    const std::vector<Object> objects{{0x1000, {4}},
                                      {0x1001, {1}},
                                      {0x1002, {4}},
                                      {0x1003, {1, 4, 4, 4, 4, 4, 4, 4, 4, 4}},
                                      {0x100C, {2}},
                                      {0x100D, {1}},
                                      {0x1010, {1, 4, 4, 4, 4}},
                                      {0x1011, {1, 4, 4, 4, 4}},
                                      {0x1016, {1, 4, 4, 4, 4}},
                                      {0x1017, {2}},
                                      {0x1018, {1, 4, 4, 4, 4}},
                                      {0x1020, {1, 4, 4}},
                                      {0x1029, {1, 1, 1, 1}},
                                      {0x1400, {1, 4, 1, 2, 1, 2}},
                                      {0x1401, {1, 4, 1, 2, 1, 2}},
                                      {0x1402, {1, 4, 1, 2, 1, 2}},
                                      {0x1403, {1, 4, 1, 2, 1, 2}},
                                      {0x1600, {1, 4, 4, 4, 4}},
                                      {0x1601, {1, 4, 4, 4, 4}},
                                      {0x1602, {1, 4, 4, 4, 4}},
                                      {0x1603, {1, 4, 4, 4, 4}},
                                      {0x1800, {1, 4, 1, 2, 1, 2}},
                                      {0x1801, {1, 4, 1, 2, 1, 2}},
                                      {0x1802, {1, 4, 1, 2, 1, 2}},
                                      {0x1803, {1, 4, 1, 2, 1, 2}},
                                      {0x1A00, {1, 4, 4, 4, 4}},
                                      {0x1A01, {1, 4, 4, 4, 4}},
                                      {0x1A02, {1, 4, 4, 4, 4}},
                                      {0x1A03, {1, 4, 4, 4, 4}},
                                      {0x2000, {1, 1, 1}},
                                      {0x2010, {1, 4, 4}},
                                      {0x2020, {1}},
                                      {0x2100, {4}},
                                      {0x2112, {1}},
                                      {0x2126, {4}},
                                      {0x2127, {4}},
                                      {0x2130, {2}},
                                      {0x3100, {4}},
                                      {0x3126, {4}},
                                      {0x3127, {4}},
                                      {0x3130, {2}},
                                      {0x4000, {1, 2, 2}},
                                      {0x4010, {1, 2, 2}},
                                      {0x4020, {1, 2, 2}},
                                      {0x4030, {1, 2, 2}},
                                      {0x5040, {1, 4, 4}},
                                      {0x5041, {1, 2, 2, 2}},
                                      {0x5042, {1, 2, 2, 2}},
                                      {0x5050, {1, 1, 1}},
                                      {0x5051, {1, 2, 2}},
                                      {0x5555, {1}},
                                      {0x5556, {2}},
                                      {0x6100, {1, 4, 4}},
                                      {0x6110, {1, 2, 2}},
                                      {0x6112, {1, 1, 1}},
                                      {0x6126, {1, 4, 4}},
                                      {0x6127, {1, 4, 4}},
                                      {0x6150, {1, 1, 1}},
                                      {0x7130, {1, 2, 2}}};
    for (const auto& object : objects) {
        for (int sub = 0; sub < static_cast<int>(object.bytes.size()); ++sub) {
            EXPECT_EQ(read(object.index, sub).size, object.bytes[static_cast<std::size_t>(sub)])
                << fmt::format("{:04X}:{}", object.index, sub);
        }
        EXPECT_EQ(read(object.index, static_cast<int>(object.bytes.size())).abort, no_subindex)
            << fmt::format("{:04X}", object.index);
    }
}

TEST_F(Ax188001Dictionary, DeviceTypeAndIdentityMatchTheManual) {
    verifies<req::TCS_OD_1000, req::TCS_OD_1002, req::TCS_OD_1018, req::TCS_OD_1020>();
    EXPECT_EQ(read(0x1000).value, 0x00020194U);
    EXPECT_EQ(read(0x1002).value, 0U);
    EXPECT_EQ(read(0x1002).size, 4);
    EXPECT_EQ(read(0x1018, 0).value, 4U);
    EXPECT_EQ(read(0x1018, 1).value, 0x00000055U);
    EXPECT_EQ(read(0x1018, 2).value, 0xAA188001U);
    EXPECT_EQ(read(0x1018, 3).value, 0x00010000U);
    EXPECT_EQ(read(0x1018, 4).value, 1U);
    EXPECT_EQ(read(0x1020, 0).value, 2U);
    EXPECT_EQ(read(0x1020, 1).value, 0x17062020U);  // 17 June 2020
    EXPECT_EQ(read(0x1020, 2).value, 0x00001200U);
    for (const int index : {0x1000, 0x1001, 0x1002}) {
        EXPECT_EQ(write(index, 0, read(index).size, 0), read_only);
    }
    for (int sub = 1; sub <= 4; ++sub) {
        EXPECT_EQ(write(0x1018, sub, 4, 0), read_only);
    }
    EXPECT_EQ(write(0x1020, 1, 4, 0), read_only);
    EXPECT_EQ(write(0x1020, 2, 4, 0), read_only);
}

TEST_F(Ax188001Dictionary, SerialNumberAndRevisionComeFromTheFactoryDataOfTheUnit) {
    verifies<req::TCS_OD_1018>();
    factory.serial_number = 0x12345678;
    factory.revision = 0x00010002;
    power_on();
    EXPECT_EQ(read(0x1018, 4).value, 0x12345678U);
    EXPECT_EQ(read(0x1018, 3).value, 0x00010002U);
}

TEST_F(Ax188001Dictionary, GuardingAndHeartbeatConsumerObjectsMatchTheManual) {
    verifies<req::TCS_OD_100C, req::TCS_OD_100D, req::TCS_OD_1016, req::TCS_OD_1017>();
    EXPECT_EQ(read(0x100C).value, 0U);
    EXPECT_EQ(read(0x100C).size, 2);
    EXPECT_EQ(write(0x100C, 0, 2, 65535), 0U);
    EXPECT_EQ(read(0x100D).value, 0U);
    EXPECT_EQ(read(0x100D).size, 1);
    EXPECT_EQ(write(0x100D, 0, 1, 255), 0U);
    EXPECT_EQ(read(0x1016, 0).value, 4U);
    EXPECT_EQ(write(0x1016, 0, 1, 1), read_only);
    for (int sub = 1; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1016, sub).value, 0U);
        EXPECT_EQ(write(0x1016, sub, 4, 0x01000000), too_high);
        EXPECT_EQ(write(0x1016, sub, 4, 0x00FFFFFF), 0U);  // node-ID 255 is unused: it monitors nothing
        EXPECT_EQ(write(0x1016, sub, 4, 0x00300005U + static_cast<std::uint32_t>(sub << 16)), 0U);
    }
    EXPECT_EQ(read(0x1016, 5).abort, no_subindex);
}

TEST_F(Ax188001Dictionary, HeartbeatIsOffOrAtLeastTenMilliseconds) {
    verifies<req::TCS_OD_1017>();
    EXPECT_EQ(read(0x1017).value, 0U);
    for (const std::uint32_t ms : {1U, 5U, 9U}) {
        EXPECT_EQ(write(0x1017, 0, 2, ms), too_low);
    }
    EXPECT_EQ(write(0x1017, 0, 2, 10), 0U);
    EXPECT_EQ(pass(25), (Frames{"10:77F#7F", "20:77F#7F"}));
    EXPECT_EQ(write(0x1017, 0, 2, 65535), 0U);
    EXPECT_EQ(write(0x1017, 0, 2, 0), 0U);
    EXPECT_EQ(pass(70000), Frames{});
}

TEST_F(Ax188001Dictionary, MeasuredValuesAreReadOnlyAndHaveTheTypesOfTheManual) {
    verifies<req::TCS_OD_6100, req::TCS_OD_6150, req::TCS_OD_7130, req::TCS_OD_2010, req::TCS_OD_2100, req::TCS_OD_2130,
             req::TCS_OD_3100, req::TCS_OD_3130, req::TCS_OD_5040>();
    struct Value {
        int index;
        int elements;  // number of elements of an ARRAY; 0 for a VAR
        int size;
    };
    for (const Value& one :
         {Value{0x6100, 2, 4}, Value{0x6150, 2, 1}, Value{0x7130, 2, 2}, Value{0x2010, 2, 4}, Value{0x2100, 0, 4},
          Value{0x2130, 0, 2}, Value{0x3100, 0, 4}, Value{0x3130, 0, 2}, Value{0x5040, 2, 4}}) {
        for (int sub = one.elements == 0 ? 0 : 1; sub <= one.elements; ++sub) {
            EXPECT_EQ(read(one.index, sub).size, one.size) << fmt::format("{:04X}:{}", one.index, sub);
            EXPECT_EQ(write(one.index, sub, one.size, 0), read_only) << fmt::format("{:04X}:{}", one.index, sub);
        }
        if (one.elements > 0) {
            EXPECT_EQ(read(one.index, 0).value, static_cast<std::uint32_t>(one.elements));
        }
        EXPECT_EQ(read(one.index, one.elements + 1).abort, no_subindex);
    }
}

TEST(Ax188001Defaults, MeasuredValuesAreZeroBeforeTheFirstReading) {
    verifies<req::TCS_OD_6100, req::TCS_OD_6150, req::TCS_OD_7130, req::TCS_OD_2010, req::TCS_OD_2100, req::TCS_OD_2130,
             req::TCS_OD_3100, req::TCS_OD_3130, req::TCS_OD_5040, req::TCS_OD_1001, req::TCS_OD_1003>();
    std::array<std::uint8_t, generated::ax188001::image_size> image{};
    image.fill(0xA5);
    ObjectDictionary objects{generated::ax188001::tables, MutableBytes{image}, LimitAbort::high_low};
    for (const auto group :
         {ParameterGroup::communication, ParameterGroup::application, ParameterGroup::manufacturer}) {
        objects.load_defaults(group, 127);
    }
    for (const int index : {0x6100, 0x6150, 0x7130, 0x2010, 0x5040}) {
        EXPECT_EQ(objects.read(static_cast<std::uint16_t>(index), 1), 0U) << index;
        EXPECT_EQ(objects.read(static_cast<std::uint16_t>(index), 2), 0U) << index;
    }
    for (const int index : {0x1001, 0x2100, 0x2130, 0x3100, 0x3130}) {
        EXPECT_EQ(objects.read(static_cast<std::uint16_t>(index), 0), 0U) << index;
    }
    for (int sub = 0; sub <= 9; ++sub) {
        // 1003h (error list) is not a parameter: it is empty after power-on, whatever the memory contained.
        const EntryRef entry = objects.lookup(0x1003, static_cast<std::uint8_t>(sub));
        ASSERT_TRUE(entry.exists()) << sub;
        EXPECT_EQ(objects.default_bits(*entry.row), 0U) << sub;
    }
}

TEST_F(Ax188001Dictionary, EachParameterHasTheElementsAndDefaultsOfTheManual) {
    verifies<req::TCS_OD_2000, req::TCS_OD_2020, req::TCS_OD_2112, req::TCS_OD_2126, req::TCS_OD_2127, req::TCS_OD_3126,
             req::TCS_OD_3127, req::TCS_OD_4000, req::TCS_OD_4010, req::TCS_OD_4020, req::TCS_OD_4030, req::TCS_OD_5041,
             req::TCS_OD_5042, req::TCS_OD_5050, req::TCS_OD_5051, req::TCS_OD_5555, req::TCS_OD_5556, req::TCS_OD_6110,
             req::TCS_OD_6112, req::TCS_OD_6126, req::TCS_OD_6127>();
    struct Parameter {
        int index;
        int size;
        std::vector<std::uint32_t> elements;  // the value of each element, or the only value of a VAR
        bool is_array;
    };
    const std::uint32_t sixteen = 0x41800000;    // 16.0F
    const std::uint32_t kelvin_16 = 0x45888000;  // 4368.0F
    for (const Parameter& one : {Parameter{0x2000, 1, {1, 1}, true},
                                 {0x2020, 1, {60}, false},
                                 {0x2112, 1, {1}, false},
                                 {0x2126, 4, {sixteen}, false},
                                 {0x2127, 4, {kelvin_16}, false},
                                 {0x3126, 4, {sixteen}, false},
                                 {0x3127, 4, {kelvin_16}, false},
                                 {0x4000, 2, {0xFF38, 0xFF38}, true},  // -200 as INTEGER16
                                 {0x4010, 2, {1250, 1250}, true},
                                 {0x4020, 2, {2500, 2500}, true},
                                 {0x4030, 2, {5000, 5000}, true},
                                 {0x5041, 2, {1100, 500, 90}, true},
                                 {0x5042, 2, {850, 480, 120}, true},
                                 {0x5050, 1, {1, 1}, true},
                                 {0x5051, 2, {5000, 5000}, true},
                                 {0x5555, 1, {0}, false},
                                 {0x5556, 2, {1000}, false},
                                 {0x6110, 2, {1, 1}, true},
                                 {0x6112, 1, {1, 1}, true},
                                 {0x6126, 4, {sixteen, sixteen}, true},
                                 {0x6127, 4, {kelvin_16, kelvin_16}, true}}) {
        const int first = one.is_array ? 1 : 0;
        for (int i = 0; i < static_cast<int>(one.elements.size()); ++i) {
            const SdoAnswer entry = read(one.index, first + i);
            EXPECT_EQ(entry.value, one.elements[static_cast<std::size_t>(i)]) << fmt::format("{:04X}", one.index);
            EXPECT_EQ(entry.size, one.size) << fmt::format("{:04X}", one.index);
            EXPECT_EQ(write(one.index, first + i, one.size, entry.value), 0U) << fmt::format("{:04X}", one.index);
        }
        EXPECT_EQ(read(one.index, first + static_cast<int>(one.elements.size())).abort, no_subindex);
        if (one.is_array) {
            EXPECT_EQ(read(one.index, 0).value, one.elements.size()) << fmt::format("{:04X}", one.index);
            EXPECT_EQ(write(one.index, 0, 1, 1), read_only);
        }
    }
}

}  // namespace canproof::test
