// SPDX-License-Identifier: Apache-2.0
// Checks every object of the AX130751 against chapter 3 of its manual: type, access, mapping, default and limits of
// each entry. The expected values are copied by hand from the pages of the objects. The tests read the generated tables
// directly; other tests cover the access over the bus.
#include "generated/ax130751/objects.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/axiomatic_sheet.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace sheet;

class Ax130751Dictionary : public AxiomaticSheet {
  protected:
    Ax130751Dictionary() : AxiomaticSheet{generated::ax130751::tables, generated::ax130751::image_size} {}
};

/// Returns the index of an object of lookup table 1…10. The objects begin at 3010h … 3090h and 3100h.
std::uint16_t lookup(int table, int object) {
    return static_cast<std::uint16_t>((table < 10 ? 0x3000 + 0x10 * table : 0x3100) + object);
}

}  // namespace

// AX130751, 3.2.1 to 3.2.13
TEST_F(Ax130751Dictionary, CommunicationObjectsMatchTheManual) {
    verifies<req::AOR_OD_1000, req::AOR_OD_1001, req::AOR_OD_1002, req::AOR_OD_100C, req::AOR_OD_100D, req::AOR_OD_1010,
             req::AOR_OD_1011, req::AOR_OD_1016, req::AOR_OD_1018, req::AOR_OD_1020, req::AOR_OD_1029>();
    check({
        {0x1000, 0, u32, Access::ro, {0xE01C0194}, none, none},
        {0x1001, 0, u8, Access::ro, {0}, 0, 1},
        {0x1002, 0, u32, Access::ro, {0}, none, none},
        {0x100C, 0, u16, Access::rw, {0}, none, none},
        {0x100D, 0, u8, Access::rw, {0}, none, none},
        {0x1010, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1011, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1016, 4, u32, Access::rw, {0}, 0, 0x00FFFFFF},  // bits 24 to 31 are reserved
        {0x1018, 4, u32, Access::ro, {0x55, 0xAA130751, 0x00010000, 1}, none, none},
        {0x1020, 2, u32, Access::ro, {0x28072023, 0}, none, none},
        {0x1029, 5, u8, Access::rw, {1}, 0, 2},
    });
}

// AX130751, 3.2.4
TEST_F(Ax130751Dictionary, ErrorListHasFourEntriesAndAcceptsOnlyAWriteOfZero) {
    verifies<req::AOR_OD_1003>();
    check_error_list(4);
    EXPECT_EQ(writing(0x1003, 0, 1), AbortCode::value_range);
}

// AX130751, 3.2.7
TEST_F(Ax130751Dictionary, WritableEntriesExceptCommandsErrorListAndLssSettingsAreStored) {
    verifies<req::AOR_STORE_004>();
    // 2500h, 6220h and 7300h are commands; 1003h, 1010h and 1011h contain no settings; LSS stores 5B50h and 5B51h
    const std::set<unsigned> left_out{0x2500, 0x6220, 0x7300, 0x1003, 0x1010, 0x1011, 0x5B50, 0x5B51};
    const DictionaryTables& tables = objects_.tables();
    for (const ObjectRow& object : tables.objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            const EntryRow& entry = tables.entries[object.first_entry + i];
            const bool is_kept = entry.may(rights::write) && left_out.count(object.index) == 0;
            EXPECT_EQ(entry.may(rights::stored), is_kept) << std::hex << object.index << ' ' << int{entry.subindex};
        }
    }
}

// AX130751, 3.2.10
TEST_F(Ax130751Dictionary, ProducerHeartbeatIsOffOrAtLeastTenMilliseconds) {
    verifies<req::AOR_OD_1017, req::AOR_HB_002>();
    check_producer_heartbeat();
}

// Sections 3.2.14 and 3.2.15: communication parameters with default COB-IDs, node 127 = 7Fh.
TEST_F(Ax130751Dictionary, PdoCommunicationParametersMatchTheManual) {
    verifies<req::AOR_OD_1400, req::AOR_OD_1401, req::AOR_OD_1402, req::AOR_OD_1403, req::AOR_OD_1800, req::AOR_OD_1801,
             req::AOR_OD_1802, req::AOR_OD_1803>();
    check_communication({
        {0x1400, 0x4000027F, 255, 0},
        {0x1401, 0xC000037F, 255, 0},
        {0x1402, 0xC000047F, 255, 0},
        {0x1403, 0x4000057F, 255, 0},
        {0x1800, 0x400001FF, 254, 100},
        {0x1801, 0xC00002FF, 254, 0},
        {0x1802, 0xC00003FF, 254, 0},
        {0x1803, 0xC00004FF, 254, 0},
    });
}

// Sections 3.2.14 and 3.2.15: mappings
TEST_F(Ax130751Dictionary, PdoMappingsMatchTheManual) {
    verifies<req::AOR_OD_1600, req::AOR_OD_1601, req::AOR_OD_1602, req::AOR_OD_1603, req::AOR_OD_1A00, req::AOR_OD_1A01,
             req::AOR_OD_1A02, req::AOR_OD_1A03>();
    check_mappings({
        {0x1600, 3, {0x73000110, 0x73000210, 0x62200308, 0}},
        {0x1601, 3, {0x25000110, 0x25000210, 0x25000310, 0}},
        {0x1602, 3, {0x25000410, 0x25000510, 0x25000610, 0}},
        {0x1603, 2, {0x62200108, 0x62200208, 0, 0}},
        {0x1A00, 2, {0x23700110, 0x23700210, 0, 0}},
        {0x1A01, 2, {0x73300110, 0x73300210, 0, 0}},
        {0x1A02, 0, {0, 0, 0, 0}},
        {0x1A03, 2, {0x50200020, 0x50300020, 0, 0}},
    });
}

// Sections 3.3.1 to 3.3.3, 3.4.1 to 3.4.3, 2230h (DO Fixed DC Frequency) of 3.4
TEST_F(Ax130751Dictionary, DigitalOutputObjectsMatchTheManual) {
    verifies<req::AOR_OD_2223, req::AOR_OD_2230, req::AOR_OD_2240, req::AOR_OD_2241, req::AOR_OD_6220, req::AOR_OD_6250,
             req::AOR_OD_6260>();
    check({
        {0x2223, 2, u16, Access::rw, {500}, 0, 60000, Map::both},
        {0x2230, 2, u16, Access::rw, {0}, none, none},
        {0x2240, 2, u8, Access::rw, {0}, 0, 1},
        {0x2241, 2, u8, Access::rw, {0}, 0, 3},
        {0x6220, 3, u8, Access::rw, {0}, none, none, Map::both, false},
        {0x6250, 2, u8, Access::rw, {1}, 0, 1},
        {0x6260, 2, flag, Access::rw, {1}, none, none},
    });
    EXPECT_EQ(writing(0x6260, 1, 2), AbortCode::value_range);
}

// AX130751, 3.4.4 to 3.4.19
TEST_F(Ax130751Dictionary, RelayObjectsMatchTheManual) {
    verifies<req::AOR_OD_2242, req::AOR_OD_2250, req::AOR_OD_2260, req::AOR_OD_2261, req::AOR_OD_2270, req::AOR_OD_2271,
             req::AOR_OD_2280, req::AOR_OD_2281, req::AOR_OD_2282, req::AOR_OD_2290, req::AOR_OD_2291, req::AOR_OD_2292,
             req::AOR_OD_2293, req::AOR_OD_22A0, req::AOR_OD_22A1, req::AOR_OD_22A2>();
    check({
        {0x2242, 1, u8, Access::rw, {1}, 0, 5},
        {0x2250, 1, u16, Access::rw, {500}, 0, 60000, Map::both},
        {0x2260, 1, u8, Access::rw, {1}, 0, 9},
        {0x2261, 1, u8, Access::rw, {3}, 0, 10},
        {0x2270, 1, u8, Access::rw, {0}, 0, 9},
        {0x2271, 1, u8, Access::rw, {0}, 0, 10},
        {0x2280, 1, u8, Access::rw, {0}, 0, 9},
        {0x2281, 1, u8, Access::rw, {0}, 0, 10},
        {0x2282, 1, u8, Access::rw, {0}, 0, 5},
        {0x2290, 1, u8, Access::rw, {0}, 0, 9},
        {0x2291, 1, u8, Access::rw, {0}, 0, 10},
        {0x2292, 1, u8, Access::rw, {0}, 0, 1},
        {0x2293, 1, u8, Access::rw, {0}, 0, 1},
        {0x22A0, 1, u8, Access::rw, {0}, 0, 1},
        {0x22A1, 1, u32, Access::rw, {0}, 0, 86400000},
        {0x22A2, 1, u32, Access::rw, {0}, 0, 86400000},
    });
}

// AX130751, 3.3.4 to 3.3.14
TEST_F(Ax130751Dictionary, AnalogueOutputObjectsOfTheDeviceProfileMatchTheManual) {
    verifies<req::AOR_OD_6302, req::AOR_OD_6332, req::AOR_OD_6340, req::AOR_OD_7300, req::AOR_OD_7320, req::AOR_OD_7321,
             req::AOR_OD_7322, req::AOR_OD_7323, req::AOR_OD_7330, req::AOR_OD_7341>();
    check({
        {0x6302, 2, u8, Access::rw, {3}, 0, 4},
        {0x6332, 2, u8, Access::rw, {3}, 0, 4},
        {0x6340, 2, u8, Access::rw, {1}, 0, 1},
        {0x7300, 2, i16, Access::rw, {0}, none, none, Map::both, false},
        {0x7320, 2, i16, Access::rw, {0}, none, 4999},  // always below 7322h (AO Output Scaling 2 PV), 5000
        {0x7321, 2, i16, Access::rw, {0}, none, none},  // the table contains no limits: the device checks the range of
                                                        // the output type
        {0x7322, 2, i16, Access::rw, {5000}, 1, none},  // always above 7320h (AO Output Scaling 1 PV), 0
        {0x7323, 2, i16, Access::rw, {5000}, none, none},
        {0x7330, 2, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x7341, 2, i16, Access::rw, {0}, none, none},
    });
    set(0x7322, 2, -10);
    EXPECT_EQ(writing(0x7320, 2, -11), AbortCode::none);
    EXPECT_EQ(writing(0x7320, 2, -10), AbortCode::value_too_high);
    EXPECT_EQ(writing(0x7320, 1, -10), AbortCode::none);  // the limit of the other output has not changed
    set(0x7320, 2, -20);
    EXPECT_EQ(writing(0x7322, 2, -19), AbortCode::none);
    EXPECT_EQ(writing(0x7322, 2, -20), AbortCode::value_too_low);
}

// AX130751, 3.3.5
TEST_F(Ax130751Dictionary, OutputTypeAcceptsTheValuesOfTable3AndOfSection1_2) {
    verifies<req::AOR_OD_6310>();
    check_count(0x6310, 2);
    for (int sub = 1; sub <= 2; ++sub) {
        check_choice({0x6310, 2, u16, Access::rw, {}, none, none}, sub, 10, {0, 10, 20, 40, 500, 1000, 1020});
        EXPECT_EQ(writing(0x6310, sub, 30), AbortCode::value_range);
    }
}

// AX130751, 3.4.20 to 3.4.33
TEST_F(Ax130751Dictionary, ManufacturerSpecificAnalogueOutputObjectsMatchTheManual) {
    verifies<req::AOR_OD_2300, req::AOR_OD_2330, req::AOR_OD_2331, req::AOR_OD_2340, req::AOR_OD_2341, req::AOR_OD_2342,
             req::AOR_OD_2350, req::AOR_OD_2351, req::AOR_OD_2352, req::AOR_OD_2360, req::AOR_OD_2361, req::AOR_OD_2362,
             req::AOR_OD_2370, req::AOR_OD_2380>();
    check({
        {0x2300, 2, i16, Access::rw, {0}, none, none},
        {0x2330, 2, u16, Access::rw, {1000}, 0, 10000},
        {0x2331, 2, u16, Access::rw, {1000}, 0, 10000},
        {0x2340, 2, u8, Access::rw, {1}, 0, 9},
        {0x2341, 2, u8, Access::rw, {1, 2}, 0, 10},
        {0x2342, 2, u8, Access::rw, {1}, 0, 2},
        {0x2350, 2, u8, Access::rw, {0}, 0, 9},
        {0x2351, 2, u8, Access::rw, {0}, 0, 10},
        {0x2352, 2, u8, Access::rw, {3}, 0, 5},
        {0x2360, 2, u8, Access::rw, {0}, 0, 9},
        {0x2361, 2, u8, Access::rw, {0}, 0, 10},
        {0x2362, 2, u8, Access::rw, {0}, 0, 1},
        {0x2370, 2, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x2380, 2, u16, Access::rw, {25000}, 0, 30000},
    });
}

// AX130751, 3.4.34 to 3.4.37
TEST_F(Ax130751Dictionary, ExtraReceivedValueObjectsMatchTheManual) {
    verifies<req::AOR_OD_2500, req::AOR_OD_2502, req::AOR_OD_2520, req::AOR_OD_2522>();
    check({
        {0x2500, 6, i16, Access::rw, {0}, none, none, Map::both, false},
        {0x2502, 6, u8, Access::rw, {1}, 0, 4},
        {0x2520, 6, i16, Access::rw, {0}, -32768, 0},  // at most the value of 2522h (EC Scaling 2 PV)
        {0x2522, 6, i16, Access::rw, {0}, 0, 32767},   // at least the value of 2520h (EC Scaling 1 PV)
    });
    set(0x2522, 4, 300);
    EXPECT_EQ(writing(0x2520, 4, 300), AbortCode::none);
    EXPECT_EQ(writing(0x2520, 4, 301), AbortCode::value_too_high);
    set(0x2520, 4, -7);
    EXPECT_EQ(writing(0x2522, 4, -7), AbortCode::none);
    EXPECT_EQ(writing(0x2522, 4, -8), AbortCode::value_too_low);
}

// Sections 3.4.38 to 3.4.46: the objects of all ten lookup tables
TEST_F(Ax130751Dictionary, LookupTableObjectsMatchTheManual) {
    verifies<req::AOR_OD_3010, req::AOR_OD_3011, req::AOR_OD_3012, req::AOR_OD_3013, req::AOR_OD_3014, req::AOR_OD_3015,
             req::AOR_OD_3016, req::AOR_OD_3017, req::AOR_OD_3018, req::AOR_OD_3020, req::AOR_OD_3021, req::AOR_OD_3022,
             req::AOR_OD_3023, req::AOR_OD_3024, req::AOR_OD_3025, req::AOR_OD_3026, req::AOR_OD_3027, req::AOR_OD_3028,
             req::AOR_OD_3030, req::AOR_OD_3031, req::AOR_OD_3032, req::AOR_OD_3033, req::AOR_OD_3034, req::AOR_OD_3035,
             req::AOR_OD_3036, req::AOR_OD_3037, req::AOR_OD_3038, req::AOR_OD_3040, req::AOR_OD_3041, req::AOR_OD_3042,
             req::AOR_OD_3043, req::AOR_OD_3044, req::AOR_OD_3045, req::AOR_OD_3046, req::AOR_OD_3047, req::AOR_OD_3048,
             req::AOR_OD_3050, req::AOR_OD_3051, req::AOR_OD_3052, req::AOR_OD_3053, req::AOR_OD_3054, req::AOR_OD_3055,
             req::AOR_OD_3056, req::AOR_OD_3057, req::AOR_OD_3058, req::AOR_OD_3060, req::AOR_OD_3061, req::AOR_OD_3062,
             req::AOR_OD_3063, req::AOR_OD_3064, req::AOR_OD_3065, req::AOR_OD_3066, req::AOR_OD_3067, req::AOR_OD_3068,
             req::AOR_OD_3070, req::AOR_OD_3071, req::AOR_OD_3072, req::AOR_OD_3073, req::AOR_OD_3074,
             req::AOR_OD_3075>();
    verifies<req::AOR_OD_3076, req::AOR_OD_3077, req::AOR_OD_3078, req::AOR_OD_3080, req::AOR_OD_3081, req::AOR_OD_3082,
             req::AOR_OD_3083, req::AOR_OD_3084, req::AOR_OD_3085, req::AOR_OD_3086, req::AOR_OD_3087, req::AOR_OD_3088,
             req::AOR_OD_3090, req::AOR_OD_3091, req::AOR_OD_3092, req::AOR_OD_3093, req::AOR_OD_3094, req::AOR_OD_3095,
             req::AOR_OD_3096, req::AOR_OD_3097, req::AOR_OD_3098, req::AOR_OD_3100, req::AOR_OD_3101, req::AOR_OD_3102,
             req::AOR_OD_3103, req::AOR_OD_3104, req::AOR_OD_3105, req::AOR_OD_3106, req::AOR_OD_3107,
             req::AOR_OD_3108>();
    const std::vector<std::int64_t> steps_of_ten{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    for (int table = 1; table <= 10; ++table) {
        check({
            {lookup(table, 0), 0, u8, Access::rw, {0}, 0, 9},
            {lookup(table, 1), 0, u8, Access::rw, {0}, 0, 10},
            {lookup(table, 2), 0, u8, Access::rw, {0}, 0, 1},
            {lookup(table, 3), 0, u8, Access::rw, {0}, 0, 4},
            {lookup(table, 4), 0, u8, Access::rw, {0}, 0, 4},
            // the table allows the limits of both responses (data: from -32768, time: up to 24 h in ms); the device
            // checks those of the chosen response
            {lookup(table, 6), 11, i32, Access::rw, steps_of_ten, -32768, 86400000},
            {lookup(table, 7), 11, i16, Access::rw, steps_of_ten, none, none},
            {lookup(table, 8), 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        });
        check_count(lookup(table, 5), 11);
        check_entry({lookup(table, 5), 11, u8, Access::rw, {}, 0, 1}, 1, 0);
        for (int point = 2; point <= 11; ++point) {
            check_entry({lookup(table, 5), 11, u8, Access::rw, {}, 0, 2}, point, 1);
        }
    }
    EXPECT_EQ(lookup(10, 8), 0x3108);
    EXPECT_EQ(objects_.find(0x30A0, 0).error(), AbortCode::object_missing);
}

// AX130751, 3.4.47 to 3.4.60
TEST_F(Ax130751Dictionary, LogicBlockObjectsMatchTheManual) {
    verifies<req::AOR_OD_3300, req::AOR_OD_3310, req::AOR_OD_3320, req::AOR_OD_3401, req::AOR_OD_3402, req::AOR_OD_3411,
             req::AOR_OD_3412, req::AOR_OD_3413, req::AOR_OD_3421, req::AOR_OD_3422, req::AOR_OD_3423, req::AOR_OD_3431,
             req::AOR_OD_3432, req::AOR_OD_3433, req::AOR_OD_3501, req::AOR_OD_3502, req::AOR_OD_3511, req::AOR_OD_3512,
             req::AOR_OD_3513, req::AOR_OD_3521, req::AOR_OD_3522, req::AOR_OD_3523, req::AOR_OD_3531, req::AOR_OD_3532,
             req::AOR_OD_3533, req::AOR_OD_3601, req::AOR_OD_3602, req::AOR_OD_3611, req::AOR_OD_3612, req::AOR_OD_3613,
             req::AOR_OD_3621, req::AOR_OD_3622, req::AOR_OD_3623, req::AOR_OD_3631, req::AOR_OD_3632,
             req::AOR_OD_3633>();
    check({
        {0x3300, 3, flag, Access::rw, {0}, none, none},
        {0x3310, 3, u8, Access::ro, {0}, none, none, Map::tpdo},
        {0x3320, 3, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x3401, 3, u8, Access::rw, {1, 2, 3}, 1, 10},
        {0x3501, 3, u8, Access::rw, {4, 5, 6}, 1, 10},
        {0x3601, 3, u8, Access::rw, {7, 8, 9}, 1, 10},
    });
    for (const int block : {0x3400, 0x3500, 0x3600}) {
        check({{static_cast<std::uint16_t>(block + 2), 3, u8, Access::rw, {1, 1, 0}, 0, 4}});
        for (const int function : {0x10, 0x20, 0x30}) {
            for (int condition = 1; condition <= 3; ++condition) {
                const auto index = static_cast<std::uint16_t>(block + function + condition);
                check_count(index, 5);
                check_entry({index, 5, u8, Access::rw, {}, 0, 9}, 1, 0);
                check_entry({index, 5, u8, Access::rw, {}, 0, 10}, 2, 0);
                check_entry({index, 5, u8, Access::rw, {}, 0, 9}, 3, 0);
                check_entry({index, 5, u8, Access::rw, {}, 0, 10}, 4, 0);
                check_entry({index, 5, u8, Access::rw, {}, 0, 5}, 5, 0);
            }
        }
    }
}

// AX130751, 3.4.61 to 3.4.73
TEST_F(Ax130751Dictionary, MathBlockObjectsMatchTheManual) {
    verifies<req::AOR_OD_4000, req::AOR_OD_4021, req::AOR_OD_4023, req::AOR_OD_4030, req::AOR_OD_4032, req::AOR_OD_4100,
             req::AOR_OD_4101, req::AOR_OD_4102, req::AOR_OD_4103, req::AOR_OD_4120, req::AOR_OD_4122, req::AOR_OD_4140,
             req::AOR_OD_4150, req::AOR_OD_4200, req::AOR_OD_4201, req::AOR_OD_4202, req::AOR_OD_4203, req::AOR_OD_4220,
             req::AOR_OD_4222, req::AOR_OD_4240, req::AOR_OD_4250, req::AOR_OD_4300, req::AOR_OD_4301, req::AOR_OD_4302,
             req::AOR_OD_4303, req::AOR_OD_4320, req::AOR_OD_4322, req::AOR_OD_4340, req::AOR_OD_4350, req::AOR_OD_4400,
             req::AOR_OD_4401, req::AOR_OD_4402, req::AOR_OD_4403, req::AOR_OD_4420, req::AOR_OD_4422, req::AOR_OD_4440,
             req::AOR_OD_4450>();
    check({
        {0x4000, 4, flag, Access::rw, {0}, none, none},
        {0x4021, 4, i16, Access::rw, {0}, none, none},
        {0x4023, 4, i16, Access::rw, {10000}, none, none},
        {0x4030, 4, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4032, 4, u8, Access::rw, {2}, 0, 4},
    });
    for (int block = 1; block <= 4; ++block) {
        const auto at = [block](int object) { return static_cast<std::uint16_t>(0x4000 + 0x100 * block + object); };
        check({
            {at(0x00), 4, u8, Access::rw, {0}, 0, 9},
            {at(0x01), 4, u8, Access::rw, {0}, 0, 10},
            {at(0x02), 4, u8, Access::rw, {0}, 0, 3},
            {at(0x03), 4, u8, Access::rw, {2}, 0, 4},
            {at(0x20), 4, i16, Access::rw, {0}, none, none},
            {at(0x22), 4, i16, Access::rw, {10000}, none, none},
            {at(0x40), 4, i8, Access::rw, {100}, -100, 100},
            {at(0x50), 3, u8, Access::rw, {12}, 0, 17},
        });
    }
}

// AX130751, 3.4.74 to 3.4.84
TEST_F(Ax130751Dictionary, DiagnosticObjectsMatchTheManual) {
    verifies<req::AOR_OD_5020, req::AOR_OD_5021, req::AOR_OD_5022, req::AOR_OD_5023, req::AOR_OD_5024, req::AOR_OD_5025,
             req::AOR_OD_5030, req::AOR_OD_5031, req::AOR_OD_5032, req::AOR_OD_5033, req::AOR_OD_5034>();
    check({
        {0x5020, 0, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x5021, 0, u8, Access::rw, {1}, 0, 1},
        {0x5022, 0, u8, Access::rw, {8}, 0, 35},   // at most the value of 5023h (Over Voltage Threshold)
        {0x5023, 0, u8, Access::rw, {35}, 8, 36},  // at least the value of 5022h (Under Voltage Threshold)
        {0x5024, 0, u8, Access::rw, {5}, 1, 30},
        {0x5025, 0, u8, Access::rw, {1}, 0, 1},
        {0x5030, 0, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x5031, 0, u8, Access::rw, {1}, 0, 1},
        {0x5032, 0, u8, Access::rw, {85}, 0, 150},
        {0x5033, 0, u8, Access::rw, {25}, 0, 150},
        {0x5034, 0, u8, Access::rw, {1}, 0, 1},
    });
    set(0x5023, 0, 20);
    EXPECT_EQ(writing(0x5022, 0, 20), AbortCode::none);
    EXPECT_EQ(writing(0x5022, 0, 21), AbortCode::value_too_high);
    set(0x5022, 0, 15);
    EXPECT_EQ(writing(0x5023, 0, 15), AbortCode::none);
    EXPECT_EQ(writing(0x5023, 0, 14), AbortCode::value_too_low);
}

// AX130751, 3.4.85 to 3.4.88
TEST_F(Ax130751Dictionary, SystemObjectsMatchTheManual) {
    verifies<req::AOR_OD_5550, req::AOR_OD_5555, req::AOR_OD_5B50, req::AOR_OD_5B51>();
    check({
        {0x5550, 0, u8, Access::rw, {1}, 0, 1},
        {0x5555, 0, flag, Access::rw, {0}, none, none},
        {0x5B51, 0, u8, Access::rw, {127}, 1, 127, Map::no, false},
    });
    EXPECT_EQ(writing(0x5555, 0, 2), AbortCode::value_range);
    // The default is 125 kbit/s; the choices are those of Table 22 without the reserved index 5.
    check_choice({0x5B50, 0, u8, Access::rw, {}, none, none, Map::no, false}, 0, 4, {0, 1, 2, 3, 4, 6, 7, 8});
    EXPECT_EQ(objects_.find(0x5B50, 1).error(), AbortCode::subindex_missing);
}

TEST_F(Ax130751Dictionary, DictionaryHasTheNumberOfObjectsAndEntriesOfTheManual) {
    verifies<req::AOR_OD_1000>();
    // Numbers of objects: 13 in sections 3.2.1 to 3.2.13, 16 of PDOs, 7 of digital outputs, 16 of the relay, 11 and 14
    // of analogue outputs, 4 of extra received values. The 10 lookup tables have 9 objects each. Logic has 3, and 11
    // for each of 3 blocks. Math has 5, and 8 for each of 4 blocks. Diagnostics have 11, the system has 4.
    EXPECT_EQ(objects_.tables().objects.count,
              13U + 16U + 7U + 16U + 11U + 14U + 4U + 10U * 9U + 3U + 3U * 11U + 5U + 4U * 8U + 11U + 4U);
    // Numbers of entries: 6 variables have one each; then come 1003h, 1010h, 1011h, 1016h, 1018h, 1020h and 1029h with
    // their sub-index 0
    const std::size_t communication = 6U + 5U + 5U + 5U + 5U + 5U + 3U + 6U;
    const std::size_t pdos = 8U * 6U + 8U * 5U;
    const std::size_t digital = 6U * 3U + 4U;
    const std::size_t relay = 16U * 2U;
    const std::size_t analogue = (11U + 14U) * 3U;
    const std::size_t extra = 4U * 7U;
    const std::size_t lookup_tables = 10U * (6U + 3U * 12U);
    const std::size_t logic = 3U * 4U + 3U * (2U * 4U + 9U * 6U);
    const std::size_t math = 5U * 5U + 4U * (7U * 5U + 4U);
    const std::size_t system = 11U + 4U;
    EXPECT_EQ(objects_.tables().entries.count,
              communication + pdos + digital + relay + analogue + extra + lookup_tables + logic + math + system);
}

}  // namespace canproof::test
