// SPDX-License-Identifier: Apache-2.0
// The words of the parameter journal in flash: what a commit writes, and which words the journal takes for valid. The
// expected words follow the description in parameter_journal.hpp, so that a new firmware reads an old journal.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "tests/support/crc32_by_definition.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::Each;
using testing::IsEmpty;

constexpr std::uint32_t erased = 0xFFFFFFFF;
constexpr std::size_t words_a_slot = 6;
using Words = std::vector<std::uint32_t>;
using Line = std::array<std::uint8_t, 16>;

/// A journal of 16 lines after power-on.
struct FormatUnit {
    Flash flash;
    JournalRam<256> ram{};
    ParameterJournal journal;

    explicit FormatUnit(FlashModel& model)
        : flash{model.registers(), 1000},
          journal{flash, model.sectors(), MutableBytes{ram.bytes}, Slots<std::uint32_t>{ram.changed}} {
        journal.open();
    }
    bool store(std::size_t at, const std::vector<std::uint8_t>& bytes) {
        return journal.write(at, ByteView{bytes.data(), bytes.size()}) && journal.commit();
    }
    std::uint8_t byte(std::size_t at) const {
        std::uint8_t value = 0;
        EXPECT_TRUE(journal.read(at, MutableBytes{&value, 1}));
        return value;
    }
};

/// Returns the CRC of words, each with its lowest byte first.
std::uint32_t crc_of(const Words& words) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t word : words) {
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            bytes.push_back(static_cast<std::uint8_t>(word >> shift));
        }
    }
    return crc32_by_definition(bytes);
}

/// Returns the header of a sector: the mark of a complete erase, "COPJ", the generation, and the CRC of these two.
Words header(std::uint32_t generation) {
    return {0, 0x4A504F43, generation, crc_of({0x4A504F43, generation}), erased, erased};
}

/// Returns a slot: line, commit and the mark of its last slot in one word, then the line and the CRC of these words.
Words slot(std::uint32_t line, std::uint32_t commit, bool is_last, const Line& content) {
    Words words{line | (commit << 12U) | (is_last ? 0x80000000U : 0)};
    for (std::size_t at = 0; at < content.size(); at += 4) {
        words.push_back(content[at] | (content[at + 1] * 0x100U) | (content[at + 2] * 0x10000U) |
                        (content[at + 3] * 0x1000000U));
    }
    words.push_back(crc_of(words));
    return words;
}

/// Returns a blank line that begins with these bytes.
Line line_of(std::initializer_list<std::uint8_t> bytes) {
    Line line;
    line.fill(0xFF);
    std::copy(bytes.begin(), bytes.end(), line.begin());
    return line;
}

void put(FlashModel& model, std::size_t sector, std::size_t at, const Words& words) {
    std::copy(words.begin(), words.end(),
              model.sector(sector).cells().begin() + static_cast<std::ptrdiff_t>(at * words_a_slot));
}

Words slot_in(FlashModel& model, std::size_t sector, std::size_t at) {
    const auto first = model.sector(sector).cells().begin() + static_cast<std::ptrdiff_t>(at * words_a_slot);
    return Words(first, first + words_a_slot);
}

}  // namespace

TEST(JournalFormat, CommitWritesHeaderAndSlotsAsDescribed) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    FormatUnit unit{model};
    ASSERT_TRUE(unit.store(2 * 16, {1, 2, 3, 4, 5}));
    EXPECT_EQ(slot_in(model, 0, 0), header(1));
    EXPECT_EQ(slot_in(model, 0, 1), slot(2, 1, true, line_of({1, 2, 3, 4, 5})));
    EXPECT_THAT(slot_in(model, 0, 2), Each(erased));
    ASSERT_TRUE(unit.journal.write(15 * 16, ByteView{std::array<std::uint8_t, 1>{7}}));
    ASSERT_TRUE(unit.store(3 * 16, {8, 9}));
    EXPECT_EQ(slot_in(model, 0, 2), slot(3, 2, false, line_of({8, 9})));
    EXPECT_EQ(slot_in(model, 0, 3), slot(15, 2, true, line_of({7})));
    EXPECT_THAT(slot_in(model, 0, 4), Each(erased));
    EXPECT_EQ(unit.journal.generation(), 1U);
    EXPECT_TRUE(model.is_locked());
}

TEST(JournalFormat, SectorCountsOnlyWithItsMarkItsNameAndItsCrc) {
    verifies<req::CO_FLASH_002>();
    const auto content_with = [](const Words& first_slot) {
        FlashModel model;
        put(model, 0, 0, first_slot);
        put(model, 0, 1, slot(0, 1, true, line_of({5})));
        return FormatUnit{model}.byte(0);
    };
    EXPECT_EQ(content_with(header(1)), 5);
    Words wrong = header(1);
    wrong[0] = erased;  // the erase was interrupted
    EXPECT_EQ(content_with(wrong), 0xFF);
    const Words other_name{0, 0x4A504F44, 1, crc_of({0x4A504F44, 1}), erased, erased};
    EXPECT_EQ(content_with(other_name), 0xFF);
    wrong = header(1);
    wrong[3] ^= 0x80U;
    EXPECT_EQ(content_with(wrong), 0xFF);
}

TEST(JournalFormat, SlotOfALineBehindTheMemoryIsNotPartOfACommit) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    put(model, 0, 0, header(1));
    put(model, 0, 1, slot(0, 1, true, line_of({5})));
    put(model, 0, 2, slot(1, 2, false, line_of({6})));
    put(model, 0, 3, slot(16, 2, true, line_of({7})));  // the memory has the lines 0 to 15
    FormatUnit unit{model};
    EXPECT_EQ(unit.byte(0), 5);
    EXPECT_EQ(unit.byte(16), 0xFF);  // commit 2 has no valid last slot
}

TEST(JournalFormat, CommitBeginsBehindTheLastSlotOfTheCommitBeforeIt) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    put(model, 0, 0, header(1));
    put(model, 0, 1, slot(0, 9, false, line_of({1})));
    put(model, 0, 2, slot(1, 9, false, line_of({2})));
    put(model, 0, 3, slot(2, 9, true, line_of({3})));
    put(model, 0, 4, slot(2, 10, true, line_of({4})));
    put(model, 0, 5, slot(3, 9, true, line_of({5})));  // numbers of commits wrap, so number 9 comes again
    FormatUnit unit{model};
    const std::array<int, 4> expected{1, 2, 4, 5};
    for (std::size_t line = 0; line < expected.size(); ++line) {
        EXPECT_EQ(unit.byte(16 * line), expected[line]);
    }
}

TEST(JournalFormat, GenerationOfASectorWrapsFromItsHighestNumberTo0) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, 3 * words_a_slot};  // each sector has room for two lines
    put(model, 0, 0, header(0xFFFFFFFF));
    put(model, 0, 1, slot(4, 0x7FFFF, true, line_of({5})));
    {
        FormatUnit unit{model};
        EXPECT_EQ(unit.byte(4 * 16), 5);
        EXPECT_EQ(unit.journal.generation(), 0xFFFFFFFFU);
        ASSERT_TRUE(unit.store(4 * 16, {6}));
        EXPECT_EQ(slot_in(model, 0, 2), slot(4, 0, true, line_of({6})));  // the number of the commit has 19 bits
        ASSERT_TRUE(unit.store(4 * 16, {7}));
    }
    EXPECT_EQ(slot_in(model, 1, 0), header(0));
    EXPECT_EQ(slot_in(model, 1, 1), slot(4, 1, true, line_of({7})));
    FormatUnit unit{model};
    EXPECT_EQ(unit.journal.generation(), 0U);
    EXPECT_EQ(unit.byte(4 * 16), 7);
}

TEST(JournalFormat, FirstCommitInASectorWithOnlyAHeaderUsesSlot1) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    put(model, 0, 0, header(1));
    put(model, 0, 1, slot(0, 1, true, line_of({1})));
    put(model, 0, 2, slot(0, 2, true, line_of({2})));
    FormatUnit unit{model};
    EXPECT_EQ(unit.byte(0), 2);
    put(model, 0, 1, Words(2 * words_a_slot, erased));
    model.restore_power();
    unit.journal.open();
    EXPECT_EQ(unit.byte(0), 0xFF);
    ASSERT_TRUE(unit.store(0, {3}));
    EXPECT_EQ(slot_in(model, 0, 0), header(1));
    EXPECT_EQ(slot_in(model, 0, 1), slot(0, 3, true, line_of({3})));
    EXPECT_THAT(slot_in(model, 0, 2), Each(erased));
    // the same after power-on, when the journal has no state from before
    put(model, 0, 1, Words(words_a_slot, erased));
    model.restore_power();
    FormatUnit after{model};
    ASSERT_TRUE(after.store(0, {4}));
    EXPECT_EQ(slot_in(model, 0, 0), header(1));
    EXPECT_EQ(slot_in(model, 0, 1), slot(0, 1, true, line_of({4})));
    EXPECT_THAT(model.faults(), IsEmpty());
}

TEST(JournalFormat, CommitAfterPowerOnUsesTheNextSlotOfTheSector) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    ASSERT_TRUE(FormatUnit{model}.store(0, {1}));
    const std::size_t before = model.operations();
    FormatUnit unit{model};
    ASSERT_TRUE(unit.store(0, {2}));
    EXPECT_EQ(model.operations(), before + words_a_slot);
    EXPECT_EQ(slot_in(model, 0, 2), slot(0, 2, true, line_of({2})));
    EXPECT_EQ(unit.journal.generation(), 1U);
}

TEST(JournalFormat, OpeningAJournalWhoseSectorWasDamagedForgetsItsContentAndGeneration) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    FormatUnit unit{model};
    ASSERT_TRUE(unit.store(0, {1}));
    EXPECT_EQ(unit.journal.generation(), 1U);
    model.sector(0).cells()[1] = 0;
    model.restore_power();
    unit.journal.open();
    EXPECT_EQ(unit.byte(0), 0xFF);
    EXPECT_EQ(unit.journal.generation(), 0U);
    ASSERT_TRUE(unit.store(0, {2}));
    EXPECT_EQ(FormatUnit{model}.byte(0), 2);
}

TEST(JournalFormat, FirstOfTwoSectorsWithTheSameGenerationCounts) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    for (const std::size_t sector : {0U, 1U}) {
        put(model, sector, 0, header(1));
        put(model, sector, 1, slot(0, 1, true, line_of({static_cast<std::uint8_t>(sector + 5)})));
    }
    EXPECT_EQ(FormatUnit{model}.byte(0), 5);
}

TEST(JournalFormat, FailedWriteOfASlotSetsItsFirstWordTo0) {
    verifies<req::CO_FLASH_003>();
    for (const std::size_t word : {1U, 3U, 5U}) {
        FlashModel model;
        FormatUnit unit{model};
        ASSERT_TRUE(unit.store(3 * 16, {1}));
        model.fail_each_after(word, {true});
        EXPECT_FALSE(unit.store(3 * 16, {2}));
        Words written = slot(3, 2, true, line_of({2}));
        written[0] = 0;
        std::fill(written.begin() + static_cast<std::ptrdiff_t>(word) + 1, written.end(), erased);
        EXPECT_EQ(slot_in(model, 0, 2), written) << word;
    }
}

}  // namespace canproof::test
