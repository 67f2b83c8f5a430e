// SPDX-License-Identifier: Apache-2.0
// Tests the check of a generated dictionary. This check runs when the C++ compiler compiles the dictionary. The test
// uses a small valid dictionary and invalid ones.
#include "firmware/canopen/dictionary_check.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/shows_rule.hpp"

namespace canproof {
namespace {

/// 1000h (device type) has one entry of 4 bytes in flash, 2001h has two entries of 1 byte each. With the hash factor 1
/// << 16, the search for index i begins in slot i & 3.
struct Dictionary {
    std::array<ObjectRow, 2> objects{{{0x1000U, 0U, 1U, ObjectKind::var}, {0x2001U, 1U, 2U, ObjectKind::array}}};
    std::array<EntryRow, 3> entries{
        {{0U, 4U, no_limit, 0U, DataType::unsigned32, rights::read | rights::constant, Service::none},
         {0U, 1U, no_limit, 0U, DataType::unsigned8, rights::read, Service::none},
         {1U, 1U, 0U, 1U, DataType::unsigned8, rights::read | rights::write, Service::none}}};
    std::array<LimitRow, 1> limits{};
    std::array<std::uint32_t, 1> allowed{};
    std::array<std::uint8_t, 4> constants{};
    std::array<std::uint8_t, 2> defaults{};
    std::array<std::uint16_t, 4> slots{{0U, 1U, no_object, no_object}};
    std::uint32_t factor{0x10000U};
    std::size_t settings_at{SIZE_MAX};

    bool sound() const {
        return is_sound(DictionaryTables{table_view(objects), table_view(entries), table_view(limits),
                                         table_view(allowed), table_view(constants), table_view(defaults), 0U,
                                         table_view(slots), factor, settings_at});
    }
};

TEST(DictionaryCheck, ValidDictionaryIsAccepted) {
    test::shows_rule("a dictionary that is compiled is sound");
    EXPECT_TRUE(Dictionary{}.sound());
    Dictionary neighbours;
    neighbours.objects[1].index = 0x1001U;
    EXPECT_TRUE(neighbours.sound());
    Dictionary two_first;  // the second object is at position 1 of `objects`, its first entry at position 2 of
                           // `entries`
    two_first.objects = {{{0x1000U, 0U, 2U, ObjectKind::array}, {0x2001U, 2U, 1U, ObjectKind::var}}};
    two_first.entries[1].subindex = 1U;
    two_first.entries[2].subindex = 0U;
    EXPECT_TRUE(two_first.sound());
}

TEST(DictionaryCheck, ObjectsOutOfOrderOrWithEntryGapsAreRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary twice;
    twice.objects[1].index = 0x1000U;
    EXPECT_FALSE(twice.sound());
    Dictionary gap;
    gap.objects[1].first_entry = 2U;
    EXPECT_FALSE(gap.sound());
    Dictionary rest;
    rest.objects[1].count = 1U;
    EXPECT_FALSE(rest.sound());
    Dictionary empty;
    empty.objects[0].count = 0U;
    EXPECT_FALSE(empty.sound());
    Dictionary empty_at_its_end;
    empty_at_its_end.objects = {{{0x1000U, 0U, 3U, ObjectKind::array}, {0x2001U, 3U, 0U, ObjectKind::var}}};
    empty_at_its_end.entries[1].subindex = 1U;
    empty_at_its_end.entries[2].subindex = 2U;
    EXPECT_FALSE(empty_at_its_end.sound());
    Dictionary overlapping;
    overlapping.objects[1].first_entry = 0U;
    overlapping.entries[1].subindex = 1U;
    EXPECT_FALSE(overlapping.sound());
}

TEST(DictionaryCheck, RepeatedSubindexIsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary twice;
    twice.entries[2].subindex = 0U;
    EXPECT_FALSE(twice.sound());
}

TEST(DictionaryCheck, ShortNumberOfNoneOrMoreThan4BytesIsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary none;
    none.entries[2].size = 0U;
    EXPECT_FALSE(none.sound());
    none.entries[2].type = DataType::domain;  // a DOMAIN has no bytes in the image
    EXPECT_TRUE(none.sound());
    constexpr std::array<std::uint8_t, 5> five_bytes{};
    const auto sound = [&five_bytes](const Dictionary& dictionary) {
        return is_sound(DictionaryTables{table_view(dictionary.objects), table_view(dictionary.entries),
                                         table_view(dictionary.limits), table_view(dictionary.allowed),
                                         table_view(five_bytes), table_view(dictionary.defaults), 0U,
                                         table_view(dictionary.slots), dictionary.factor});
    };
    Dictionary longer;
    EXPECT_TRUE(sound(longer));
    longer.entries[0].size = 5U;
    EXPECT_FALSE(sound(longer));
    longer.entries[0].type = DataType::real32;
    EXPECT_FALSE(sound(longer));
    longer.entries[0].type = DataType::visible_string;
    EXPECT_TRUE(sound(longer));
}

TEST(DictionaryCheck, MoreThan8PdosOfADirectionAreRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    // With the hash factor 1 << 16 the search begins in slot 3 for 1407h, 1807h, 15FFh and 19FFh. For 1408h, 1808h,
    // 1600h and 1A00h it begins in slot 0, where 1000h is, and continues in slot 1.
    const auto with = [](const std::uint16_t index, const std::size_t slot) {
        Dictionary dictionary;
        dictionary.objects[1].index = index;
        dictionary.slots = {{no_object, no_object, no_object, no_object}};
        dictionary.slots[0] = 0U;
        dictionary.slots[slot] = 1U;
        return dictionary.sound();
    };
    EXPECT_TRUE(with(0x1407U, 3U));
    EXPECT_TRUE(with(0x1807U, 3U));
    EXPECT_FALSE(with(0x1408U, 1U));
    EXPECT_FALSE(with(0x15FFU, 3U));
    EXPECT_FALSE(with(0x1808U, 1U));
    EXPECT_FALSE(with(0x19FFU, 3U));
    EXPECT_TRUE(with(0x1600U, 1U));
    EXPECT_TRUE(with(0x1A00U, 1U));
}

TEST(DictionaryCheck, ObjectWithoutSubindex0IsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary without;
    without.entries[0].subindex = 1U;
    EXPECT_FALSE(without.sound());
    Dictionary second_without;
    second_without.entries[1].subindex = 1U;
    second_without.entries[2].subindex = 2U;
    EXPECT_FALSE(second_without.sound());
}

TEST(DictionaryCheck, EntryWhoseValueLiesOutsideItsMemoryImageIsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary flash;
    flash.entries[0].offset = 1U;
    EXPECT_FALSE(flash.sound());
    Dictionary memory;
    memory.entries[2].size = 2U;
    EXPECT_FALSE(memory.sound());
}

TEST(DictionaryCheck, EntryThatRefersToAMissingLimitRowIsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary missing;
    missing.entries[2].limit = 1U;
    EXPECT_FALSE(missing.sound());
}

TEST(DictionaryCheck, HashTableIsAcceptedOnlyIfItFindsEachObjectAndEndsEachSearch) {
    test::shows_rule("a dictionary that is compiled is sound");
    Dictionary lost;
    lost.slots = {{0U, no_object, no_object, no_object}};
    EXPECT_FALSE(lost.sound());
    Dictionary later;  // the search for 2000h begins in slot 0, where 1000h is, and ends in slot 1, where 2000h is
    later.objects[1].index = 0x2000U;
    EXPECT_TRUE(later.sound());
    Dictionary behind_a_gap;  // 2001h is in slot 2, but the search for it begins and ends at slot 1, which is free
    behind_a_gap.slots = {{0U, no_object, 1U, no_object}};
    EXPECT_FALSE(behind_a_gap.sound());
    Dictionary apart;  // 2002h is in slot 2, where the search for it begins; slot 1 is free
    apart.objects[1].index = 0x2002U;
    apart.slots = {{0U, no_object, 1U, no_object}};
    EXPECT_TRUE(apart.sound());
    Dictionary onwards;  // the search for both objects begins in slot 1; the second object is in slot 2
    onwards.objects[0].index = 0x1001U;
    onwards.slots = {{no_object, 0U, 1U, no_object}};
    EXPECT_TRUE(onwards.sound());
    Dictionary round;  // the search for both objects begins in slot 3; the second object is in slot 0
    round.objects[0].index = 0x1003U;
    round.objects[1].index = 0x2003U;
    round.slots = {{1U, no_object, no_object, 0U}};
    EXPECT_TRUE(round.sound());
    Dictionary full;
    full.slots = {{0U, 0U, 0U, 0U}};
    EXPECT_FALSE(full.sound());
    Dictionary odd;  // with three slots, the mask of the search skips one slot
    std::array<std::uint16_t, 3> three{{0U, 1U, no_object}};
    EXPECT_FALSE(
        has_free_slot(DictionaryTables{table_view(odd.objects), {}, {}, {}, {}, {}, 0U, table_view(three), 1U}));
    std::array<std::uint16_t, 2> two{{0U, 1U}};
    EXPECT_FALSE(has_free_slot(DictionaryTables{table_view(odd.objects), {}, {}, {}, {}, {}, 0U, table_view(two), 1U}));
    const Dictionary
        tight;  // the search finds each object (slots 1000h & 1 and 2001h & 1), but never ends for an absent one
    EXPECT_FALSE(is_sound(DictionaryTables{
        table_view(tight.objects), table_view(tight.entries), table_view(tight.limits), table_view(tight.allowed),
        table_view(tight.constants), table_view(tight.defaults), 0U, table_view(two), tight.factor}));
}

TEST(DictionaryCheck, SettingsThatAreMappedOrNotInWholeWordsAreRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    struct WithSettings : Dictionary {
        std::array<std::uint8_t, 8> image{};
        bool sound_with(std::size_t at, std::size_t size) const {
            return has_sound_settings(DictionaryTables{
                table_view(objects), table_view(entries), {}, {}, {}, {image.data(), size}, 0U, {}, factor, at});
        }
    };
    WithSettings one;
    one.entries[2].offset = 4U;
    EXPECT_TRUE(one.sound_with(4, 8));
    EXPECT_TRUE(one.sound_with(8, 8));
    EXPECT_TRUE(one.sound_with(SIZE_MAX, 7));
    EXPECT_TRUE(one.sound_with(7, 7)) << "no value lies behind the image";
    EXPECT_FALSE(one.sound_with(2, 8));
    EXPECT_FALSE(one.sound_with(4, 7));
    for (const std::uint32_t right : {std::uint32_t{rights::rpdo}, std::uint32_t{rights::tpdo}}) {
        WithSettings mapped = one;
        mapped.entries[2].rights = static_cast<std::uint8_t>(mapped.entries[2].rights | right);
        EXPECT_FALSE(mapped.sound_with(4, 8));
        EXPECT_TRUE(mapped.sound_with(8, 8));
        WithSettings constant = one;
        constant.entries[0].offset = 4U;  // an offset among the constants, which are no settings
        constant.entries[0].rights = static_cast<std::uint8_t>(constant.entries[0].rights | right);
        EXPECT_TRUE(constant.sound_with(4, 8));
    }
}

TEST(DictionaryCheck, DictionaryWithMappedSettingsIsRefused) {
    test::shows_rule("a dictionary that is compiled is sound");
    struct InWords : Dictionary {
        std::array<std::uint8_t, 4> image{};
        bool sound_from(std::size_t at) const {
            return is_sound(DictionaryTables{table_view(objects), table_view(entries), table_view(limits),
                                             table_view(allowed), table_view(constants), table_view(image), 0U,
                                             table_view(slots), factor, at});
        }
    };
    InWords mapped;
    mapped.entries[2].rights = static_cast<std::uint8_t>(mapped.entries[2].rights | rights::rpdo);
    EXPECT_TRUE(mapped.sound_from(4));
    EXPECT_FALSE(mapped.sound_from(0));
}

}  // namespace
}  // namespace canproof
