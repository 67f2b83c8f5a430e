// SPDX-License-Identifier: Apache-2.0
// Tests the search for entries of an object with absent sub-indices (firmware/canopen/object_dictionary.hpp), the
// number of PDOs of a dictionary, and which writes change settings.
#include "firmware/canopen/object_dictionary.hpp"

#include <gtest/gtest.h>

#include <array>

#include "firmware/canopen/dictionary_check.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof {
namespace {

/// 2000h:0, and 2001h with the sub-indices 0, 3, 4 and 5, each of 4 bytes. Sub-indices 3 to 5 have the limits 0 to 2.
/// The hash factor 1 << 16 puts index i into slot i & 3, so 2001h is in slot 1. Entry 2001h:0 is the second of all
/// entries.
struct SparseDictionary {
    static constexpr EntryRow word(std::uint16_t offset, std::uint16_t limit, std::uint8_t subindex) {
        return {offset, 4U, limit, subindex, DataType::unsigned32, rights::read | rights::write, Service::none};
    }

    std::array<ObjectRow, 2> rows{{{0x2000U, 0U, 1U, ObjectKind::var}, {0x2001U, 1U, 4U, ObjectKind::record}}};
    std::array<EntryRow, 5> entries{
        {word(0U, no_limit, 0U), word(4U, no_limit, 0U), word(8U, 0U, 3U), word(12U, 1U, 4U), word(16U, 2U, 5U)}};
    std::array<LimitRow, 3> limits{};
    std::array<std::uint8_t, 20> defaults{{0x01U, 0x02U, 0x03U, 0x04U, 0x05U, 0x06U, 0x07U, 0x08U, 0x09U, 0x0AU,
                                           0x0BU, 0x0CU, 0x0DU, 0x0EU, 0x0FU, 0x10U, 0x11U, 0x12U, 0x13U, 0x14U}};
    std::array<std::uint16_t, 4> slots{{0U, 1U, no_object, no_object}};
    DictionaryTables tables{
        table_view(rows), table_view(entries), table_view(limits), {}, {}, table_view(defaults), 0U, table_view(slots),
        0x10000U};
    std::array<std::uint8_t, 20> image{};
    ObjectDictionary objects{tables, MutableBytes{image}, LimitAbort::range};
};

TEST(ObjectDictionary, EntryBehindAbsentSubindicesIsFound) {
    test::shows_rule("each entry of a dictionary is found");
    const SparseDictionary sparse;
    ASSERT_TRUE(is_sound(sparse.tables));
    for (const std::uint8_t subindex : std::array<std::uint8_t, 4>{0U, 3U, 4U, 5U}) {
        const EntryRef entry = sparse.objects.lookup(0x2001U, subindex);
        ASSERT_TRUE(entry.exists()) << int{subindex};
        EXPECT_EQ(entry.row->subindex, subindex);
    }
    for (const std::uint8_t subindex : std::array<std::uint8_t, 4>{1U, 2U, 6U, 255U}) {
        EXPECT_FALSE(sparse.objects.lookup(0x2001U, subindex).exists()) << int{subindex};
    }
    EXPECT_FALSE(sparse.objects.lookup(0x2000U, 1U).exists());
}

TEST(ObjectDictionary, DefaultOfAnEntryWithLimitsIsLoadedWithAllItsBytes) {
    test::shows_rule("a default is loaded with all of its bytes");
    SparseDictionary sparse;
    sparse.objects.load_defaults(ParameterGroup::manufacturer, 5U);
    EXPECT_EQ(sparse.image, sparse.defaults);
    EXPECT_EQ(sparse.objects.read(0x2001U, 3U), 0x0C0B0A09U);
}

TEST(ObjectDictionary, ValueOfAnEntryHasTheBytesOfThisEntryOnly) {
    test::shows_rule("each entry of a dictionary is found");
    SparseDictionary sparse;
    sparse.objects.load_defaults(ParameterGroup::manufacturer, 5U);
    EXPECT_EQ(sparse.objects.bits(*sparse.objects.lookup(0x2001U, 3U).row), 0x0C0B0A09U);
    EXPECT_EQ(sparse.objects.bits(*sparse.objects.lookup(0x2001U, 4U).row), 0x100F0E0DU);
    EXPECT_EQ(sparse.objects.bits(*sparse.objects.lookup(0x2001U, 5U).row), 0x14131211U);
}

// The self-test of the settings would take a write that is not counted for a fault of the RAM. After a write that is
// counted although it changes no setting, the self-test would overlook a fault of the RAM.
TEST(ObjectDictionary, ExactlyTheWritesOfSettingsAreCounted) {
    test::verifies<req::CO_SELF_019>();
    SparseDictionary sparse;
    sparse.tables.settings_at = 12U;  // 2001h:4 and 2001h:5 are settings
    ObjectDictionary objects{sparse.tables, MutableBytes{sparse.image}, LimitAbort::range};
    const std::array<std::uint8_t, 4> bytes{{1U, 2U, 3U, 4U}};
    for (const std::uint8_t subindex : std::array<std::uint8_t, 4>{0U, 3U, 4U, 5U}) {
        const bool is_setting = subindex >= 4U;
        const EntryRef entry = objects.lookup(0x2001U, subindex);
        std::uint32_t before = objects.setting_changes();
        const auto is_counted = [&objects, &before] {
            const std::uint32_t last = before;
            before = objects.setting_changes();
            return before != last;
        };
        objects.put(entry, ByteView{bytes.data(), bytes.size()});
        EXPECT_EQ(is_counted(), is_setting) << int{subindex};
        objects.put_bits(*entry.row, 7U);
        EXPECT_EQ(is_counted(), is_setting) << int{subindex};
        objects.write(0x2001U, subindex, 8U);
        EXPECT_EQ(is_counted(), is_setting) << int{subindex};
        objects.set(Field<std::uint32_t>{entry.row->offset}, std::uint32_t{9U});
        EXPECT_EQ(is_counted(), is_setting) << int{subindex};
        EXPECT_EQ(objects.read(0x2001U, subindex), 9U);
    }
}

/// Returns the numbers of RPDOs and TPDOs of a dictionary whose only object is `index`.
std::pair<std::size_t, std::size_t> pdos_with(const std::uint16_t index) {
    const std::array<ObjectRow, 1> rows{{{index, 0U, 1U, ObjectKind::record}}};
    const DictionaryTables tables{table_view(rows), {}, {}, {}, {}, {}, 0U, {}, 0U};
    return {pdo_count(tables, PdoDirection::receive), pdo_count(tables, PdoDirection::transmit)};
}

// CiA 301, Table 40: the communication parameters of RPDO1 are 1400h, those of TPDO1 are 1800h.
TEST(ObjectDictionary, NumberOfPdosOfADirectionIsItsHighestPdoNumber) {
    test::shows_rule("a dictionary that is compiled is sound");
    using Counts = std::pair<std::size_t, std::size_t>;
    EXPECT_EQ(pdos_with(0x13FFU), (Counts{0U, 0U}));
    EXPECT_EQ(pdos_with(0x1400U), (Counts{1U, 0U}));
    EXPECT_EQ(pdos_with(0x1403U), (Counts{4U, 0U}));
    EXPECT_EQ(pdos_with(0x1407U), (Counts{8U, 0U}));
    EXPECT_EQ(pdos_with(0x1408U), (Counts{0U, 0U})) << "the node serves eight";
    EXPECT_EQ(pdos_with(0x1800U), (Counts{0U, 1U}));
    EXPECT_EQ(pdos_with(0x1807U), (Counts{0U, 8U}));
}

}  // namespace
}  // namespace canproof
