// SPDX-License-Identifier: Apache-2.0
// The parameter journal at the limits of its memory, its lines and its sectors.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::Each;
using testing::IsEmpty;

constexpr std::size_t words_in_a_slot = 6;

/// A journal of `Size` bytes after power-on. Behind the bits of its changed lines lies a word that is not its own.
template <std::size_t Size>
struct SizedUnit {
    Flash flash;
    JournalRam<Size> ram{};
    std::vector<std::uint32_t> changed;
    ParameterJournal journal;

    /// `bits`: the content of the RAM for the changed lines, and of the word behind it, before power-on.
    explicit SizedUnit(FlashModel& model, std::uint32_t bits = 0) : SizedUnit{model, model.sectors(), bits} {}
    SizedUnit(FlashModel& model, const std::array<FlashSector, 2>& sectors, std::uint32_t bits = 0)
        : flash{model.registers(), 1000},
          changed(ram.changed.size() + 1, bits),
          journal{flash, sectors, MutableBytes{ram.bytes}, Slots<std::uint32_t>{changed.data(), ram.changed.size()}} {
        journal.open();
    }
    bool write(std::size_t at, const std::vector<std::uint8_t>& bytes) {
        return journal.write(at, ByteView{bytes.data(), bytes.size()});
    }
    bool store(std::size_t at, const std::vector<std::uint8_t>& bytes) { return write(at, bytes) && journal.commit(); }
    std::uint8_t byte(std::size_t at) const {
        std::uint8_t value = 0;
        EXPECT_TRUE(journal.read(at, MutableBytes{&value, 1}));
        return value;
    }
};

}  // namespace

TEST(JournalSize, AccessUpToTheLastByteIsPermittedAndNoAccessBehindIt) {
    verifies<req::CO_FLASH_003>();
    FlashModel model;
    SizedUnit<256> unit{model};
    std::vector<std::uint8_t> two{1, 2};
    const MutableBytes to{two.data(), two.size()};
    EXPECT_TRUE(unit.write(254, {8, 9}));
    EXPECT_TRUE(unit.write(256, {}));
    EXPECT_FALSE(unit.write(257, {}));
    EXPECT_FALSE(unit.write(255, {5, 6}));
    EXPECT_EQ(unit.byte(255), 9);
    EXPECT_TRUE(unit.journal.read(256, MutableBytes{}));
    EXPECT_FALSE(unit.journal.read(257, MutableBytes{}));
    EXPECT_FALSE(unit.journal.read(300, to));
    EXPECT_FALSE(unit.journal.read(255, to));
    EXPECT_EQ(two, (std::vector<std::uint8_t>{1, 2}));  // a refused read changes nothing
    EXPECT_TRUE(unit.journal.read(254, to));
    EXPECT_EQ(two, (std::vector<std::uint8_t>{8, 9}));
}

TEST(JournalSize, EachByteThatDiffersIsWritten) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    {
        SizedUnit<256> unit{model};
        ASSERT_TRUE(unit.store(40, {0, 1, 1}));
        ASSERT_TRUE(unit.store(40, {1, 1, 2}));  // the third byte differs from the first one and from the old byte
    }
    SizedUnit<256> unit{model};
    EXPECT_EQ(unit.byte(40), 1);
    EXPECT_EQ(unit.byte(41), 1);
    EXPECT_EQ(unit.byte(42), 2);
    ASSERT_TRUE(unit.store(40, {0}));
    ASSERT_TRUE(unit.store(40, {0xFF}));
    EXPECT_EQ(unit.byte(40), 0xFF);
}

TEST(JournalSize, CommitWithoutAChangeDoesNothing) {
    verifies<req::CO_FLASH_002>();
    for (const std::uint32_t ram : {0U, 0xFFFFFFFFU}) {  // power-on leaves any content in RAM
        FlashModel model;
        SizedUnit<256> unit{model, ram};
        EXPECT_TRUE(unit.journal.commit());
        EXPECT_EQ(model.operations(), 0U);
        EXPECT_EQ(unit.journal.generation(), 0U);
    }
}

TEST(JournalSize, PreparedFlashIsLockedAndItsCacheIsOn) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    SizedUnit<256> unit{model};
    EXPECT_TRUE(unit.journal.prepare());
    EXPECT_EQ(model.erases(0), 1U);
    EXPECT_TRUE(model.is_locked());
    EXPECT_TRUE(model.caches_data());
}

TEST(JournalSize, LineOfEachNumberIsStoredAlone) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    SizedUnit<1024> unit{model};  // 64 lines, whose bits fill two words
    ASSERT_TRUE(unit.store(0, {1}));
    for (std::size_t line = 0; line < 64; ++line) {
        const std::size_t before = model.operations();
        ASSERT_TRUE(unit.store(line * 16 + 15, {static_cast<std::uint8_t>(line + 100)}));
        EXPECT_EQ(model.operations(), before + words_in_a_slot) << line;
        EXPECT_EQ(SizedUnit<1024>{model}.byte(line * 16 + 15), line + 100);
    }
}

TEST(JournalSize, BitsBehindThoseOfTheLastLineAreNotUsed) {
    verifies<req::CO_FLASH_002>();
    for (const std::uint32_t behind : {0U, 0xFFFFFFFFU}) {
        FlashModel model;
        SizedUnit<512> unit{model, behind};  // the bits of 32 lines fill one word
        ASSERT_TRUE(unit.store(31 * 16, {1}));
        ASSERT_TRUE(unit.store(31 * 16, {2}));
        EXPECT_EQ(unit.changed, (std::vector<std::uint32_t>{0, behind}));
        EXPECT_EQ(SizedUnit<512>{model}.byte(31 * 16), 2);
        // erase and mark, the slots of two commits, and the header without the mark
        EXPECT_EQ(model.operations(), 2 + 2 * words_in_a_slot + 3);
    }
}

TEST(JournalSize, LineWithOnlyItsFirstByteMovesToTheOtherSector) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, 3 * words_in_a_slot};
    {
        SizedUnit<256> unit{model};
        ASSERT_TRUE(unit.store(0, {1}));
        for (const std::uint8_t value : {std::uint8_t{2}, std::uint8_t{3}}) {
            ASSERT_TRUE(unit.store(5 * 16 + 15, {value}));
        }
        EXPECT_EQ(unit.journal.generation(), 2U);
    }
    SizedUnit<256> unit{model};
    EXPECT_EQ(unit.byte(0), 1);
    EXPECT_EQ(unit.byte(5 * 16 + 15), 3);
}

TEST(JournalSize, CommitThatJustFitsIntoTheSectorStaysThere) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, 20 * words_in_a_slot};
    SizedUnit<256> unit{model};
    for (std::uint8_t number = 1; number <= 19; ++number) {  // one slot of 20 is the header
        ASSERT_TRUE(unit.store(16, {number}));
        EXPECT_EQ(unit.journal.generation(), 1U);
    }
    EXPECT_EQ(model.erases(1), 0U);
    ASSERT_TRUE(unit.store(16, {20}));
    EXPECT_EQ(unit.journal.generation(), 2U);
    EXPECT_EQ(SizedUnit<256>{model}.byte(16), 20);
}

TEST(JournalSize, SectorsOfDifferentSizesAreBothFilledToTheirOwnEnd) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, 20 * words_in_a_slot};
    std::array<FlashSector, 2> sectors = model.sectors();
    sectors[1].words = sectors[1].words.part(0, 10 * words_in_a_slot);
    SizedUnit<256> unit{model, sectors};
    for (std::uint8_t number = 1; number <= 19 + 9; ++number) {
        ASSERT_TRUE(unit.store(16, {number})) << +number;
        EXPECT_EQ(unit.journal.generation(), number <= 19 ? 1U : 2U);
    }
    ASSERT_TRUE(unit.store(16, {29}));
    EXPECT_EQ(unit.journal.generation(), 3U);
    EXPECT_EQ((SizedUnit<256>{model, sectors}.byte(16)), 29);
}

TEST(JournalSize, MemoryWithMoreLinesThanASectorHasRoomForIsRefused) {
    verifies<req::CO_FLASH_003>();
    FlashModel model{1, 20 * words_in_a_slot};
    SizedUnit<512> unit{model};  // 32 lines; the sector has room for 19
    EXPECT_FALSE(unit.store(0, std::vector<std::uint8_t>(512, 1)));
    EXPECT_EQ(unit.byte(0), 0xFF);
    EXPECT_TRUE(unit.store(0, {2}));
    EXPECT_EQ(SizedUnit<512>{model}.byte(0), 2);
    EXPECT_THAT(model.faults(), IsEmpty());
}

}  // namespace canproof::test
