// SPDX-License-Identifier: Apache-2.0
// Checks every object of the AX060805 against chapter 4 of its manual and the decisions of the register: type, access,
// mapping, default at node 127 and limits of each entry. The expected values are copied by hand from the pages of the
// objects.
#include "generated/ax060805/objects.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/axiomatic_sheet.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace sheet;

class InclinometerObjectSheet : public AxiomaticSheet {
  protected:
    InclinometerObjectSheet() : AxiomaticSheet{generated::ax060805::tables, generated::ax060805::image_size} {}
};

// The manual gives the range of these REAL32 objects as "-0xFFFFFFFF to 0xFFFFFFFF".
const std::int64_t most = bits(4294967295.0F);
const std::int64_t least_of_all = bits(-4294967295.0F);

}  // namespace

// AX060805, 4.2.1 to 4.2.13
TEST_F(InclinometerObjectSheet, CommunicationObjectsMatchTheManual) {
    verifies<req::INC_OD_1000, req::INC_OD_1001, req::INC_OD_1002, req::INC_OD_100C, req::INC_OD_100D, req::INC_OD_1010,
             req::INC_OD_1011, req::INC_OD_1016, req::INC_OD_1018, req::INC_OD_1020, req::INC_OD_1029>();
    check({
        {0x1000, 0, u32, Access::ro, {0x1003019A}, none, none},
        {0x1001, 0, u8, Access::ro, {0}, none, none},
        {0x1002, 0, u32, Access::ro, {0}, none, none},
        {0x100C, 0, u16, Access::rw, {0}, 0, 65535},
        {0x100D, 0, u8, Access::rw, {0}, 0, 255},
        {0x1010, 3, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1011, 3, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1016, 1, u32, Access::rw, {0}, 0, 0x00FFFFFF},  // bits 24 to 31 are reserved
        {0x1018, 4, u32, Access::ro, {0x55, 0xAA060805, 0x00010101, 1}, none, none},
        {0x1020, 2, u32, Access::ro, {0x01012024, 0}, none, none},
        {0x1029, 2, u8, Access::rw, {0}, 0, 2},
    });
}

// Section 4.2.4: 1003h (error list) has four entries; only 0 can be written to its sub-index 0.
TEST_F(InclinometerObjectSheet, ErrorListMatchesTheManual) {
    verifies<req::INC_OD_1003>();
    check_error_list(4);
}

// Section 4.2.10: the producer heartbeat time is 0 (off), or 10 to 65535 ms
TEST_F(InclinometerObjectSheet, ProducerHeartbeatMatchesTheManual) {
    verifies<req::INC_OD_1017>();
    check_producer_heartbeat();
}

// Sections 4.2.14 and 4.2.15: the COB-IDs are those of node 127 (7Fh).
TEST_F(InclinometerObjectSheet, PdoCommunicationParametersMatchTheManual) {
    verifies<req::INC_OD_1400, req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1800, req::INC_OD_1801,
             req::INC_OD_1802, req::INC_OD_1803>();
    check_communication({
        {0x1400, 0x4000027F, 255, 0},
        {0x1401, 0xC000037F, 255, 0},
        {0x1402, 0xC000047F, 255, 0},
        {0x1403, 0xC000057F, 255, 0},
        {0x1800, 0x400001FF, 254, 250},
        {0x1801, 0x400002FF, 254, 0},
        {0x1802, 0x400003FF, 254, 0},
        {0x1803, 0xC00004FF, 254, 0},
    });
}

// Sections 4.2.14 and 4.2.15: mappings
TEST_F(InclinometerObjectSheet, PdoMappingsMatchTheManual) {
    verifies<req::INC_OD_1600, req::INC_OD_1601, req::INC_OD_1602, req::INC_OD_1603, req::INC_OD_1A00, req::INC_OD_1A01,
             req::INC_OD_1A02, req::INC_OD_1A03>();
    check_mappings({
        {0x1600, 3, {0x25000110, 0x25000210, 0x25000310, 0}},
        {0x1601, 0, {0, 0, 0, 0}},
        {0x1602, 0, {0, 0, 0, 0}},
        {0x1603, 0, {0, 0, 0, 0}},
        {0x1A00, 4, {0x40300010, 0x40400010, 0x40500010, 0x40200008}},
        {0x1A01, 4, {0x40000110, 0x40000210, 0x40000310, 0x40600010}},
        {0x1A02, 2, {0x50200020, 0x50300020, 0, 0}},
        {0x1A03, 0, {0, 0, 0, 0}},
    });
}

// AX060805, 4.3.1 to 4.3.12
TEST_F(InclinometerObjectSheet, SensorAndFilterObjectsMatchTheManual) {
    verifies<req::INC_OD_2000, req::INC_OD_2002, req::INC_OD_2003, req::INC_OD_2010, req::INC_OD_2011, req::INC_OD_2020,
             req::INC_OD_2030, req::INC_OD_2031, req::INC_OD_2040, req::INC_OD_2050, req::INC_OD_2051,
             req::INC_OD_2052>();
    check({
        {0x2000, 0, u8, Access::rw, {0}, 0, 1},
        {0x2002, 0, u8, Access::rw, {1}, 0, 1},
        {0x2003, 0, u8, Access::rw, {5}, 1, 50},
        {0x2010, 3, u16, Access::rw, {1}, 1, 1000},
        {0x2011, 3, u8, Access::rw, {0}, 0, 1},
        {0x2020, 3, real, Access::rw, {0}, least_of_all, most},
        {0x2030, 3, u16, Access::rw, {1}, 1, 1000},
        {0x2031, 3, u8, Access::rw, {0}, 0, 1},
        {0x2040, 3, real, Access::rw, {0}, least_of_all, most},
        {0x2050, 3, u8, Access::rw, {0}, 0, 2},  // 2050h: the three filter types of Table 4
        {0x2051, 3, u16, Access::rw, {10}, 1, 60000},
        {0x2052, 0, u16, Access::rw, {10}, 1, 60000},
    });
}

// Sections 4.3.13 to 4.3.18. 2300h (Auto-Null Command) is a command, so 1010h does not store it.
TEST_F(InclinometerObjectSheet, AngleObjectsMatchTheManual) {
    verifies<req::INC_OD_2100, req::INC_OD_2200, req::INC_OD_2210, req::INC_OD_2300, req::INC_OD_2400,
             req::INC_OD_2401>();
    check({
        {0x2100, 0, u8, Access::rw, {1}, 0, 1},
        {0x2200, 0, real, Access::rw, {0}, bits(-90.0F), bits(90.0F)},
        {0x2210, 0, real, Access::rw, {0}, bits(-180.0F), bits(180.0F)},
        {0x2300, 0, u8, Access::rw, {0}, 0, 1, Map::no, false},
        {0x2400, 0, real, Access::ro, {0}, bits(-90.0F), bits(90.0F)},
        {0x2401, 0, real, Access::ro, {0}, bits(-180.0F), bits(180.0F)},
    });
}

// Sections 4.3.19 to 4.3.21. 2500h (received values) is no parameter, so 1010h does not store it.
TEST_F(InclinometerObjectSheet, ReceivedValueObjectsMatchTheManual) {
    verifies<req::INC_OD_2500, req::INC_OD_2501, req::INC_OD_2502>();
    check({
        {0x2500, 3, i16, Access::rw, {0}, none, none, Map::rpdo, false},
        {0x2501, 3, u16, Access::rw, {1000}, 10, 1000},
        {0x2502, 3, real, Access::rw, {0}, least_of_all, most},
    });
}

// Sections 4.3.22 to 4.3.32: Table 1 has 29 sources, Table 9 has four unary functions, Table 10 has 21 binary
// functions.
TEST_F(InclinometerObjectSheet, BinaryFunctionObjectsMatchTheManual) {
    verifies<req::INC_OD_3000, req::INC_OD_300A, req::INC_OD_300B, req::INC_OD_300C>();
    verifies<req::INC_OD_3010, req::INC_OD_3011, req::INC_OD_3012, req::INC_OD_3013, req::INC_OD_3014, req::INC_OD_3015,
             req::INC_OD_3020, req::INC_OD_3021, req::INC_OD_3022, req::INC_OD_3023, req::INC_OD_3024, req::INC_OD_3025,
             req::INC_OD_3030, req::INC_OD_3031, req::INC_OD_3032, req::INC_OD_3033, req::INC_OD_3034, req::INC_OD_3035,
             req::INC_OD_3040, req::INC_OD_3041, req::INC_OD_3042, req::INC_OD_3043, req::INC_OD_3044, req::INC_OD_3045,
             req::INC_OD_3050, req::INC_OD_3051, req::INC_OD_3052, req::INC_OD_3053, req::INC_OD_3054,
             req::INC_OD_3055>();
    verifies<req::INC_OD_3060, req::INC_OD_3061, req::INC_OD_3062, req::INC_OD_3063, req::INC_OD_3064, req::INC_OD_3065,
             req::INC_OD_3070, req::INC_OD_3071, req::INC_OD_3072, req::INC_OD_3073, req::INC_OD_3074, req::INC_OD_3075,
             req::INC_OD_3080, req::INC_OD_3081, req::INC_OD_3082, req::INC_OD_3083, req::INC_OD_3084, req::INC_OD_3085,
             req::INC_OD_3090, req::INC_OD_3091, req::INC_OD_3092, req::INC_OD_3093, req::INC_OD_3094, req::INC_OD_3095,
             req::INC_OD_30A0, req::INC_OD_30A1, req::INC_OD_30A2, req::INC_OD_30A3, req::INC_OD_30A4,
             req::INC_OD_30A5>();
    check({
        {0x3000, 10, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x300A, 10, u8, Access::rw, {0}, 0, 20},
        {0x300B, 10, real, Access::rw, {bits(1.0F)}, least_of_all, most},
        {0x300C, 10, real, Access::rw, {0}, least_of_all, most},
    });
    for (int function = 1; function <= 10; ++function) {
        const auto at = [&](int object) { return static_cast<std::uint16_t>(0x3000 + 0x10 * function + object); };
        check({
            {at(0), 2, u8, Access::rw, {0}, 0, 28},
            {at(1), 2, u8, Access::rw, {0}, 0, 1},
            {at(2), 2, real, Access::rw, {0}, least_of_all, most},
            {at(3), 2, u8, Access::rw, {0}, 0, 3},
            {at(4), 2, real, Access::rw, {bits(1.0F)}, least_of_all, most},
            {at(5), 2, real, Access::rw, {0}, least_of_all, most},
        });
    }
}

// AX060805, 4.3.33 to 4.3.45
TEST_F(InclinometerObjectSheet, MeasuredValuesAndConstantsMatchTheManual) {
    verifies<req::INC_OD_4000, req::INC_OD_4010, req::INC_OD_4020, req::INC_OD_4030, req::INC_OD_4040, req::INC_OD_4050,
             req::INC_OD_4060, req::INC_OD_4070, req::INC_OD_4080, req::INC_OD_5020, req::INC_OD_5030, req::INC_OD_5550,
             req::INC_OD_5555>();
    check({
        {0x4000, 3, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4010, 0, u16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4020, 0, u8, Access::ro, {0}, none, none, Map::tpdo},
        {0x4030, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4040, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4050, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4060, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x4070, 0, real, Access::rw, {0}, least_of_all, most, Map::tpdo},
        {0x4080, 0, u32, Access::rw, {0}, 0, 0xFFFFFFFF, Map::tpdo},
        {0x5020, 0, real, Access::ro, {0}, 0, bits(70.0F), Map::tpdo},
        {0x5030, 0, real, Access::ro, {0}, bits(-50.0F), bits(150.0F), Map::tpdo},
        {0x5550, 0, flag, Access::rw, {1}, none, none},
        {0x5555, 0, flag, Access::rw, {0}, none, none},
    });
}

}  // namespace canproof::test
