// SPDX-License-Identifier: Apache-2.0
// Checks every object of the AX188001 against sections 3.2 to 3.4 of its manual: type, access, mapping, default at node
// 127 and limits of each entry. The expected values are copied by hand from the pages of the objects.
#include "generated/ax188001/objects.hpp"
#include "generated/ax188001/requirements.hpp"
#include "tests/support/axiomatic_sheet.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace sheet;

class Ax188001ObjectSheet : public AxiomaticSheet {
  protected:
    Ax188001ObjectSheet() : AxiomaticSheet{generated::ax188001::tables, generated::ax188001::image_size} {}
};

}  // namespace

// AX188001, 3.2.1 to 3.2.13
TEST_F(Ax188001ObjectSheet, CommunicationObjectsMatchTheManual) {
    verifies<req::TCS_OD_1000, req::TCS_OD_1001, req::TCS_OD_1002, req::TCS_OD_100C, req::TCS_OD_100D, req::TCS_OD_1010,
             req::TCS_OD_1011, req::TCS_OD_1016, req::TCS_OD_1018, req::TCS_OD_1020, req::TCS_OD_1029>();
    check({
        {0x1000, 0, u32, Access::ro, {0x00020194}, none, none},
        {0x1001, 0, u8, Access::ro, {0}, none, none},
        {0x1002, 0, u32, Access::ro, {0}, none, none},
        {0x100C, 0, u16, Access::rw, {0}, 0, 65535},
        {0x100D, 0, u8, Access::rw, {0}, 0, 255},
        {0x1010, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1011, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1016, 4, u32, Access::rw, {0}, 0, 0x00FFFFFF},  // bits 24 to 31 are reserved
        {0x1018, 4, u32, Access::ro, {0x55, 0xAA188001, 0x00010000, 1}, none, none},
        {0x1020, 2, u32, Access::ro, {0x17062020, 0x1200}, none, none},
        {0x1029, 3, u8, Access::rw, {0, 1, 0}, 0, 2},
    });
}

// Section 3.2.4: 1003h (error list) has nine entries; only 0 can be written to its sub-index 0.
TEST_F(Ax188001ObjectSheet, ErrorListMatchesTheManual) {
    verifies<req::TCS_OD_1003>();
    check_error_list(9);
}

// Section 3.2.10: the producer heartbeat time is 0 (off), or 10 to 65535 ms
TEST_F(Ax188001ObjectSheet, ProducerHeartbeatMatchesTheManual) {
    verifies<req::TCS_OD_1017>();
    check_producer_heartbeat();
}

// Sections 3.2.14 and 3.2.15: the COB-IDs are those of node 127 (7Fh).
TEST_F(Ax188001ObjectSheet, PdoCommunicationParametersMatchTheManual) {
    verifies<req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402, req::TCS_OD_1403, req::TCS_OD_1800, req::TCS_OD_1801,
             req::TCS_OD_1802, req::TCS_OD_1803>();
    check_communication({
        {0x1400, 0xC000027F, 255, 0},
        {0x1401, 0xC000037F, 255, 0},
        {0x1402, 0xC000047F, 255, 0},
        {0x1403, 0xC000057F, 255, 0},
        {0x1800, 0x400001FF, 254, 1000},
        {0x1801, 0xC00002FF, 254, 0},
        {0x1802, 0xC00003FF, 254, 0},
        {0x1803, 0xC00004FF, 254, 0},
    });
}

// Section 3.2.14: no RPDO can be mapped
TEST_F(Ax188001ObjectSheet, MappingsOfReceivePdosAreEmptyAndReadOnly) {
    verifies<req::TCS_OD_1600, req::TCS_OD_1601, req::TCS_OD_1602, req::TCS_OD_1603>();
    for (const int index : {0x1600, 0x1601, 0x1602, 0x1603}) {
        const auto at = static_cast<std::uint16_t>(index);
        check_entry({at, 0, u8, Access::ro, {}, none, none}, 0, 0);
        for (int sub = 1; sub <= 4; ++sub) {
            check_entry({at, 4, u32, Access::ro, {}, none, none}, sub, 0);
        }
        EXPECT_EQ(objects_.find(at, 5).error(), AbortCode::subindex_missing);
    }
}

// AX188001, 3.2.15
TEST_F(Ax188001ObjectSheet, MappingsOfTransmitPdosMatchTheManual) {
    verifies<req::TCS_OD_1A00, req::TCS_OD_1A01, req::TCS_OD_1A02, req::TCS_OD_1A03>();
    check_mappings({{0x1A00, 2, {0x71300110, 0x71300210, 0, 0}},
                    {0x1A01, 2, {0x21300010, 0x31300010, 0, 0}},
                    {0x1A02, 0, {0, 0, 0, 0}},
                    {0x1A03, 0, {0, 0, 0, 0}}});
}

// AX188001, 3.3.1 to 3.3.7
TEST_F(Ax188001ObjectSheet, ApplicationObjectsMatchTheManual) {
    verifies<req::TCS_OD_6100, req::TCS_OD_6112, req::TCS_OD_6126, req::TCS_OD_6127, req::TCS_OD_6150,
             req::TCS_OD_7130>();
    check({
        {0x6100, 2, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x6112, 2, u8, Access::rw, {1}, 0, 1},
        {0x6126, 2, real, Access::rw, {bits(16.0F)}, bits(-1000.0F), bits(1000.0F)},
        {0x6127, 2, real, Access::rw, {bits(4368.0F)}, bits(-10000.0F), bits(10000.0F)},
        {0x6150, 2, u8, Access::ro, {0}, none, none, Map::tpdo},
        {0x7130, 2, i16, Access::ro, {0}, none, none, Map::tpdo},
    });
}

// AX188001, 3.3.2, 3.4.3
TEST_F(Ax188001ObjectSheet, ThermocoupleTypesAndFiltersMatchTheManual) {
    verifies<req::TCS_OD_6110, req::TCS_OD_2020>();
    check_count(0x6110, 2);
    for (int sub = 1; sub <= 2; ++sub) {
        // Table 1 has the types J, K, N, R, S, T, E and B; the default, 1, is type J
        check_choice({0x6110, 2, u16, Access::rw, {}, none, none}, sub, 1, {1, 2, 4, 5, 6, 7, 9, 10});
    }
    check_choice({0x2020, 0, u8, Access::rw, {}, none, none}, 0, 60, {50, 60});
    EXPECT_EQ(objects_.find(0x2020, 1).error(), AbortCode::subindex_missing);
}

// AX188001, 3.4.1 to 3.4.12
TEST_F(Ax188001ObjectSheet, AverageAndColdJunctionObjectsMatchTheManual) {
    verifies<req::TCS_OD_2000, req::TCS_OD_2010, req::TCS_OD_2100, req::TCS_OD_2112, req::TCS_OD_2126, req::TCS_OD_2127,
             req::TCS_OD_2130, req::TCS_OD_3100, req::TCS_OD_3126, req::TCS_OD_3127, req::TCS_OD_3130>();
    check({
        {0x2000, 2, u8, Access::rw, {1}, 0, 1},
        {0x2010, 2, i32, Access::ro, {0}, none, none},
        {0x2100, 0, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x2112, 0, u8, Access::rw, {1}, 0, 1},
        {0x2126, 0, real, Access::rw, {bits(16.0F)}, bits(-1000.0F), bits(1000.0F)},
        {0x2127, 0, real, Access::rw, {bits(4368.0F)}, bits(-10000.0F), bits(10000.0F)},
        {0x2130, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
        {0x3100, 0, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x3126, 0, real, Access::rw, {bits(16.0F)}, bits(-1000.0F), bits(1000.0F)},
        {0x3127, 0, real, Access::rw, {bits(4368.0F)}, bits(-10000.0F), bits(10000.0F)},
        {0x3130, 0, i16, Access::ro, {0}, none, none, Map::tpdo},
    });
}

// Sections 3.4.13 to 3.4.16: the thresholds are at least 10 degrees (100 tenths) apart.
TEST_F(Ax188001ObjectSheet, ThresholdObjectsMatchTheManual) {
    verifies<req::TCS_OD_4000, req::TCS_OD_4010, req::TCS_OD_4020, req::TCS_OD_4030>();
    check({
        {0x4000, 2, i16, Access::rw, {-200}, -2730, 1250 - 100},
        {0x4010, 2, i16, Access::rw, {1250}, -200 + 100, 2500 - 100},
        {0x4020, 2, i16, Access::rw, {2500}, 1250 + 100, 17350},
        {0x4030, 2, u16, Access::rw, {5000}, 0, 60000},
    });
    set(0x4010, 2, 300);
    EXPECT_EQ(writing(0x4000, 2, 200), AbortCode::none);
    EXPECT_EQ(writing(0x4000, 2, 201), AbortCode::value_too_high);
    EXPECT_EQ(writing(0x4000, 1, 201), AbortCode::none);  // the limit of the other channel has not changed
    EXPECT_EQ(writing(0x4020, 2, 400), AbortCode::none);
    EXPECT_EQ(writing(0x4020, 2, 399), AbortCode::value_too_low);
    set(0x4000, 2, 100);
    set(0x4020, 2, 900);
    EXPECT_EQ(writing(0x4010, 2, 200), AbortCode::none);
    EXPECT_EQ(writing(0x4010, 2, 199), AbortCode::value_too_low);
    EXPECT_EQ(writing(0x4010, 2, 800), AbortCode::none);
    EXPECT_EQ(writing(0x4010, 2, 801), AbortCode::value_too_high);
}

// AX188001, 3.4.17 to 3.4.23
TEST_F(Ax188001ObjectSheet, FaultDetectionAndStartObjectsMatchTheManual) {
    verifies<req::TCS_OD_5040, req::TCS_OD_5050, req::TCS_OD_5051, req::TCS_OD_5555, req::TCS_OD_5556>();
    check({
        {0x5040, 2, real, Access::ro, {0}, none, none, Map::tpdo},
        {0x5050, 2, u8, Access::rw, {1}, 0, 1},
        {0x5051, 2, u16, Access::rw, {5000}, 0, 10000},
        {0x5555, 0, u8, Access::rw, {0}, 0, 2},
        {0x5556, 0, u16, Access::rw, {1000}, 0, 65000},
    });
}

// Sections 3.4.18 and 3.4.19: 5041h has the set thresholds, 5042h the clear thresholds, for high temperature, high
// voltage and low voltage (sub-indices 1 to 3).
TEST_F(Ax188001ObjectSheet, FaultDetectionThresholdsMatchTheManual) {
    verifies<req::TCS_OD_5041, req::TCS_OD_5042>();
    check_count(0x5041, 3);
    check_count(0x5042, 3);
    check_entry({0x5041, 3, u16, Access::rw, {}, 850, 1250}, 1, 1100);
    check_entry({0x5041, 3, u16, Access::rw, {}, 480, 1000}, 2, 500);
    check_entry({0x5041, 3, u16, Access::rw, {}, 80, 120}, 3, 90);
    check_entry({0x5042, 3, u16, Access::rw, {}, 500, 1100}, 1, 850);
    check_entry({0x5042, 3, u16, Access::rw, {}, 120, 500}, 2, 480);
    check_entry({0x5042, 3, u16, Access::rw, {}, 90, 480}, 3, 120);
    set(0x5042, 1, 700);
    set(0x5042, 2, 300);
    set(0x5042, 3, 200);
    check_entry({0x5041, 3, u16, Access::rw, {}, 700, 1250}, 1, 1100);
    check_entry({0x5041, 3, u16, Access::rw, {}, 300, 1000}, 2, 500);
    check_entry({0x5041, 3, u16, Access::rw, {}, 80, 200}, 3, 90);
    check_entry({0x5042, 3, u16, Access::rw, {}, 200, 500}, 2, 300);
    check_entry({0x5042, 3, u16, Access::rw, {}, 90, 300}, 3, 200);
    set(0x5041, 1, 900);
    set(0x5041, 2, 400);
    set(0x5041, 3, 100);
    check_entry({0x5042, 3, u16, Access::rw, {}, 500, 900}, 1, 700);
    check_entry({0x5042, 3, u16, Access::rw, {}, 200, 400}, 2, 300);
    check_entry({0x5042, 3, u16, Access::rw, {}, 100, 300}, 3, 200);
}

}  // namespace canproof::test
