// SPDX-License-Identifier: Apache-2.0
// Checks the object pages that the three Axiomatic manuals have in common: node-ID 127 as shipped, four PDOs per
// direction, error list, heartbeat. The test of each device gives the values in which the devices differ.
#pragma once

#include "tests/support/object_sheet.hpp"

namespace canproof::test {

namespace sheet {

/// The communication parameters of one PDO (1400h…1403h or 1800h…1803h). The COB-ID is that of node 127.
struct PdoCommunication {
    std::uint16_t index;
    std::int64_t cob_id;
    std::int64_t type;
    std::int64_t timer;
};

/// The mapping of one PDO (1600h…1603h or 1A00h…1A03h): the number of used entries, and all four entries.
struct PdoMapping {
    std::uint16_t index;
    std::int64_t count;
    std::vector<std::int64_t> entries;
};

}  // namespace sheet

class AxiomaticSheet : public ObjectSheet {
  protected:
    AxiomaticSheet(const DictionaryTables& tables, std::size_t image_size)
        : ObjectSheet{tables, image_size, LimitAbort::high_low, 127} {}

    /// Checks 1003h pre-defined error field: its number of entries, and that sub-index 0 accepts only 0.
    void check_error_list(int entries) const {
        using namespace sheet;
        check_choice({0x1003, 0, u8, Access::rw, {}, none, none, Map::no, false}, 0, 0, {0});
        for (int sub = 1; sub <= entries; ++sub) {
            check_entry({0x1003, entries, u32, Access::ro, {}, none, none}, sub, 0);
        }
        EXPECT_EQ(objects_.find(0x1003, static_cast<std::uint8_t>(entries + 1)).error(), AbortCode::subindex_missing);
    }
    /// Checks 1017h producer heartbeat time: 0 (off), or 10 to 65535 ms.
    void check_producer_heartbeat() {
        using namespace sheet;
        check({{0x1017, 0, u16, Access::rw, {0}, none, none}});
        for (int value = 1; value <= 9; ++value) {
            EXPECT_EQ(writing(0x1017, 0, value), AbortCode::value_too_low) << value;
        }
        for (const int value : {0, 10, 65535}) {
            EXPECT_EQ(writing(0x1017, 0, value), AbortCode::none) << value;
        }
    }
    /// Checks the communication parameters of PDOs: COB-ID and event timer as given, a transmission type that cannot be
    /// changed, and 0 as inhibit time and as compatibility entry (sub-index 4).
    void check_communication(const std::vector<sheet::PdoCommunication>& pdos) const {
        using namespace sheet;
        for (const PdoCommunication& pdo : pdos) {
            check_count(pdo.index, 5);
            check_entry({pdo.index, 5, u32, Access::rw, {}, none, none}, 1, pdo.cob_id);
            check_entry({pdo.index, 5, u8, Access::ro, {}, none, none}, 2, pdo.type);
            check_entry({pdo.index, 5, u16, Access::rw, {}, none, none}, 3, 0);
            check_entry({pdo.index, 5, u8, Access::rw, {}, none, none}, 4, 0);
            check_entry({pdo.index, 5, u16, Access::rw, {}, none, none}, 5, pdo.timer);
        }
    }
    /// Checks PDO mappings that the CANopen master may change.
    void check_mappings(const std::vector<sheet::PdoMapping>& mappings) const {
        using namespace sheet;
        for (const PdoMapping& mapping : mappings) {
            check_entry({mapping.index, 0, u8, Access::rw, {}, 0, 4}, 0, mapping.count);
            for (int sub = 1; sub <= 4; ++sub) {
                check_entry({mapping.index, 4, u32, Access::rw, {}, none, none}, sub,
                            mapping.entries.at(static_cast<std::size_t>(sub - 1)));
            }
            EXPECT_EQ(objects_.find(mapping.index, 5).error(), AbortCode::subindex_missing);
        }
    }
};

}  // namespace canproof::test
