// SPDX-License-Identifier: Apache-2.0
// Checks every object of the CAN-CBX-AO412 against chapter 7 of its manual: type, access, storing by 1010h (store
// parameters), mapping, default at node 3, limits. The expected values are copied by hand from the pages of the
// objects.
#include "tests/support/object_sheet.hpp"

#include "generated/cbx_ao412/objects.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace sheet;

class CbxObjectSheet : public ObjectSheet {
  protected:
    CbxObjectSheet()
        : ObjectSheet{generated::cbx_ao412::tables, generated::cbx_ao412::image_size, LimitAbort::range, 3} {}
};

}  // namespace

// CAN-CBX-AO412 manual, sections 7.9.2 to 7.9.23
TEST_F(CbxObjectSheet, CommunicationObjectsMatchTheManual) {
    verifies<req::AO4_OD_1000, req::AO4_OD_1001, req::AO4_OD_1002, req::AO4_OD_1005, req::AO4_OD_1006, req::AO4_OD_100C,
             req::AO4_OD_100D, req::AO4_OD_100E, req::AO4_OD_1010, req::AO4_OD_1011, req::AO4_OD_1014, req::AO4_OD_1015,
             req::AO4_OD_1016, req::AO4_OD_1017, req::AO4_OD_1018, req::AO4_OD_1019, req::AO4_OD_1020, req::AO4_OD_1029,
             req::AO4_OD_1F91, req::AO4_STORE_003>();
    check({
        {0x1000, 0, u32, Access::ro, {0x00080191}, none, none},
        {0x1001, 0, u8, Access::ro, {0}, none, none},
        {0x1002, 0, u32, Access::ro, {0}, none, none},
        {0x1005, 0, u32, Access::rw, {0x80}, none, none},  // the table has no limits: the SYNC service itself checks
                                                           // the identifier
        {0x1006, 0, u32, Access::rw, {0}, 0, 0xFFFFFFFF},
        {0x100C, 0, u16, Access::rw, {0}, none, none},
        {0x100D, 0, u8, Access::rw, {0}, none, none},
        {0x100E, 0, u32, Access::rw, {0x703}, none, none},
        {0x1010, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1011, 4, u32, Access::rw, {1}, none, none, Map::no, false},
        {0x1014, 0, u32, Access::rw, {0x83}, none, none},
        {0x1015, 0, u16, Access::rw, {0}, 0, 0xFFFF},
        {0x1016, 1, u32, Access::rw, {0}, 0, 0x007FFFFF},
        {0x1017, 0, u16, Access::rw, {0}, 0, 0xFFFF},
        {0x1018, 4, u32, Access::ro, {0x17, 0x23040002, 0x00020004, 0xC1C20105}, none, none},
        {0x1019, 0, u8, Access::rw, {0}, 0, 240},  // 1 is reserved: the SYNC service refuses it
        {0x1020, 2, u32, Access::rw, {0}, 0, 0xFFFFFFFF},
        {0x1029, 1, u8, Access::rw, {0}, 0, 2},
        {0x1F91, 1, u16, Access::rw, {100}, 0, 0xFFFF},
    });
}

// Section 7.9.4: 1003h (error list) has ten entries; only 0 can be written to its sub-index 0.
TEST_F(CbxObjectSheet, ErrorListMatchesTheManual) {
    verifies<req::AO4_OD_1003>();
    check_choice({0x1003, 0, u8, Access::rw, {}, none, none, Map::no, false}, 0, 0, {0});
    for (int sub = 1; sub <= 10; ++sub) {
        check_entry({0x1003, 10, u32, Access::ro, {}, none, none}, sub, 0);
    }
    EXPECT_EQ(objects_.find(0x1003, 11).error(), AbortCode::subindex_missing);
}

// Sections 7.9.7 to 7.9.9: hardware and software version may have eight characters.
TEST_F(CbxObjectSheet, TextObjectsMatchTheManual) {
    verifies<req::AO4_OD_1008, req::AO4_OD_1009, req::AO4_OD_100A>();
    check_text(0x1008, 13, "CAN-CBX-AO412");
    check_text(0x1009, 8, "1.00");
    check_text(0x100A, 8, "2.04");
}

// CAN-CBX-AO412 manual, section 7.9.22
TEST_F(CbxObjectSheet, NmtStartup1F80hIsTwoOrEight) {
    verifies<req::AO4_OD_1F80>();
    check_choice({0x1F80, 0, u32, Access::rw, {}, none, none}, 0, 2, {2, 8});
    EXPECT_EQ(objects_.find(0x1F80, 1).error(), AbortCode::subindex_missing);
}

// CAN-CBX-AO412 manual, section 7.9.24
TEST_F(CbxObjectSheet, PdoCommunicationParametersMatchTheManual) {
    verifies<req::AO4_OD_1401, req::AO4_OD_1402>();
    check_count(0x1401, 2);
    check_entry({0x1401, 2, u32, Access::rw, {}, none, none}, 1, 0x303);
    check_entry({0x1401, 2, u8, Access::rw, {}, 0, 0xFF}, 2, 0xFF);
    check_count(0x1402, 2);
    check_entry({0x1402, 2, u32, Access::rw, {}, none, none}, 1, 0x403);
    check_entry({0x1402, 2, u8, Access::rw, {}, 0, 0xFF}, 2, 0xFF);
}

// Section 7.9.25: RPDO3 maps four dummy entries of INTEGER16.
TEST_F(CbxObjectSheet, PdoMappingsMatchTheManual) {
    verifies<req::AO4_OD_1601, req::AO4_OD_1602>();
    const std::vector<std::int64_t> outputs{0x64110110, 0x64110210, 0x64110310, 0x64110410};
    for (const int index : {0x1601, 0x1602}) {
        const auto at = static_cast<std::uint16_t>(index);
        check_entry({at, 0, u8, Access::rw, {}, 0, 4}, 0, 4);
        for (int sub = 1; sub <= 4; ++sub) {
            check_entry({at, 4, u32, Access::rw, {}, none, none}, sub,
                        index == 0x1601 ? outputs[static_cast<std::size_t>(sub - 1)] : 0x00030010);
        }
        EXPECT_EQ(objects_.find(at, 5).error(), AbortCode::subindex_missing);
    }
}

// Sections 7.10.2 to 7.11.3: only 6411h (Write Analogue Output 16-Bit) may be mapped.
TEST_F(CbxObjectSheet, OutputAndCalibrationObjectsMatchTheManual) {
    verifies<req::AO4_OD_6411, req::AO4_OD_6443, req::AO4_OD_6444, req::AO4_OD_2404, req::AO4_OD_2405,
             req::AO4_STORE_003>();
    check({
        {0x2404, 4, i16, Access::rw, {0}, none, none},
        {0x2405, 4, i16, Access::rw, {0}, none, none},
        {0x6411, 4, i16, Access::rw, {0}, none, none, Map::rpdo},
        {0x6443, 4, u8, Access::rw, {1}, 0, 2},
        {0x6444, 4, i32, Access::rw, {0}, none, none},
    });
}

// CAN-CBX-AO412 manual, section 7.12
TEST_F(CbxObjectSheet, FirmwareUpdateObjectsMatchTheManual) {
    verifies<req::AO4_OD_1F50, req::AO4_OD_1F51, req::AO4_OD_1F52>();
    const EntryRef program = entry(0x1F50, 0);
    EXPECT_EQ(program.row->type, DataType::domain);
    EXPECT_EQ(program.row->size, 0U);
    EXPECT_TRUE(program.may(rights::read));
    EXPECT_TRUE(program.may(rights::write));
    EXPECT_FALSE(program.may(rights::stored));
    EXPECT_FALSE(program.may(rights::rpdo));
    EXPECT_FALSE(program.may(rights::tpdo));
    EXPECT_FALSE(program.may(rights::node_id));
    EXPECT_EQ(objects_.find(0x1F50, 1).error(), AbortCode::subindex_missing);
    check({
        {0x1F51, 1, u8, Access::rw, {0}, 0, 0xFE, Map::no, false},
    });
    check_count(0x1F52, 2);
    check_entry({0x1F52, 2, u32, Access::ro, {}, none, none}, 1, 11285);
    check_entry({0x1F52, 2, u32, Access::ro, {}, 0, 0x05265C00}, 2, 0);
}

}  // namespace canproof::test
