// SPDX-License-Identifier: Apache-2.0
// Parameter memory in two flash sectors, with a model of the flash controller: committed data survive a power cut at
// any word and during any erase.
#include "target/stm32f405/parameter_journal.hpp"

#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::IsEmpty;

constexpr std::size_t size = 256;  // the journal has 16 lines of 16 bytes
using Bytes = std::vector<std::uint8_t>;

/// A flash driver and a journal after power-on. A new Unit on the same FlashModel is the state after a power cut: RAM
/// is lost, the flash keeps its content.
struct Unit {
    Flash flash;
    JournalRam<size> ram{};
    ParameterJournal journal;

    explicit Unit(FlashModel& model)
        : flash{model.registers(), 1000},
          journal{flash, model.sectors(), MutableBytes{ram.bytes}, Slots<std::uint32_t>{ram.changed}} {
        journal.open();
    }
    bool store(std::size_t at, const Bytes& bytes) {
        return journal.write(at, ByteView{bytes.data(), bytes.size()}) && journal.commit();
    }
    Bytes content() const {
        Bytes bytes(size);
        EXPECT_TRUE(journal.read(0, MutableBytes{bytes.data(), bytes.size()}));
        return bytes;
    }
};

Bytes blank() {
    return Bytes(size, 0xFF);
}

Bytes with(Bytes bytes, std::size_t at, const Bytes& part) {
    std::copy(part.begin(), part.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
    return bytes;
}

/// Two functions give the data (20 bytes) and the place of the `number`th save of a test. The places are 36 bytes
/// apart, so some saves cross the border between two lines of 16 bytes.
Bytes pattern(std::size_t number) {
    return Bytes(20, static_cast<std::uint8_t>(number));
}
std::size_t place(std::size_t number) {
    return number * 36 % (size - 20);
}

/// The size of a small sector in words: 20 slots of 6 words. The second sector is used after a few saves.
constexpr std::size_t small_sector = 20 * 6;

}  // namespace

TEST(ParameterJournal, BlankFlashIsReadAsABlankJournal) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    Unit unit{model};
    EXPECT_EQ(unit.content(), blank());
    EXPECT_EQ(unit.journal.size(), size);
    EXPECT_EQ(unit.journal.generation(), 0U);
    EXPECT_EQ(model.operations(), 0U);
}

TEST(ParameterJournal, OnlyCommittedBytesAreKept) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    {
        Unit unit{model};
        ASSERT_TRUE(unit.journal.prepare());
        ASSERT_TRUE(unit.store(100, {1, 2, 3}));
        ASSERT_TRUE(unit.journal.write(0, ByteView{Bytes{9, 9}.data(), 2}));
        EXPECT_EQ(unit.content(), with(with(blank(), 100, {1, 2, 3}), 0, {9, 9}));
    }
    EXPECT_EQ(Unit{model}.content(), with(blank(), 100, {1, 2, 3}));
    EXPECT_TRUE(model.is_locked());
    EXPECT_THAT(model.faults(), IsEmpty());
}

TEST(ParameterJournal, UnchangedBytesAreNotProgrammed) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    Unit unit{model};
    ASSERT_TRUE(unit.store(32, Bytes(48, 7)));
    const std::size_t before = model.operations();
    ASSERT_TRUE(unit.store(32, Bytes(48, 7)));
    EXPECT_EQ(model.operations(), before);
    ASSERT_TRUE(unit.store(40, {8}));
    EXPECT_EQ(model.operations(), before + 6);  // the six words of one slot
}

TEST(ParameterJournal, AccessOutsideTheJournalIsRefused) {
    verifies<req::CO_FLASH_003>();
    FlashModel model;
    Unit unit{model};
    Bytes two(2);
    EXPECT_FALSE(unit.journal.write(size - 1, ByteView{two.data(), 2}));
    EXPECT_FALSE(unit.journal.write(size + 1, ByteView{two.data(), 0}));
    EXPECT_FALSE(unit.journal.read(size - 1, MutableBytes{two.data(), 2}));
    EXPECT_TRUE(unit.journal.read(size - 2, MutableBytes{two.data(), 2}));
    EXPECT_TRUE(unit.journal.read(size, MutableBytes{}));
    EXPECT_EQ(unit.content(), blank());
}

TEST(ParameterJournal, JournalContinuesInTheOtherSectorAndErasesTheFullOneAtPowerOn) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, small_sector};
    Bytes expected = blank();
    for (std::size_t number = 1; number <= 60; ++number) {
        Unit unit{model};
        ASSERT_TRUE(unit.journal.prepare());
        const std::size_t erased = model.erases(0) + model.erases(1);
        ASSERT_TRUE(unit.store(place(number), pattern(number))) << number;
        EXPECT_EQ(model.erases(0) + model.erases(1), erased) << "no commit has to erase";
        expected = with(expected, place(number), pattern(number));
        ASSERT_EQ(Unit{model}.content(), expected) << number;
    }
    EXPECT_GT(Unit{model}.journal.generation(), 4U);
    EXPECT_LE(model.erases(0), model.erases(1) + 1);
    EXPECT_LE(model.erases(1), model.erases(0) + 1);
    EXPECT_THAT(model.faults(), IsEmpty());
    EXPECT_THAT(model.sector(0).faults(), IsEmpty());
}

TEST(ParameterJournal, CommitErasesTheOtherSectorIfPrepareHasNotErasedIt) {
    verifies<req::CO_FLASH_002>();
    FlashModel model{1, small_sector};
    Unit unit{model};
    Bytes expected = blank();
    for (std::size_t number = 1; number <= 60; ++number) {
        ASSERT_TRUE(unit.store(place(number), pattern(number))) << number;
        expected = with(expected, place(number), pattern(number));
    }
    EXPECT_GT(model.erases(0), 0U);
    EXPECT_GT(model.erases(1), 0U);
    EXPECT_EQ(Unit{model}.content(), expected);
}

TEST(ParameterJournal, PowerCutAtAnyFlashOperationLeavesTheOldOrTheNewContent) {
    verifies<req::CO_FLASH_002>();
    constexpr std::size_t saves = 12;
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        for (std::size_t cut = 1;; ++cut) {
            FlashModel model{seed, small_sector};
            model.cut_power_after(cut);
            Bytes confirmed = blank();
            Bytes attempted = blank();
            std::size_t number = 0;
            {
                Unit unit{model};
                bool goes_on = unit.journal.prepare();
                while (goes_on && number < saves) {
                    ++number;
                    attempted = with(confirmed, place(number), pattern(number));
                    goes_on = unit.store(place(number), pattern(number));
                    confirmed = goes_on ? attempted : confirmed;
                }
                if (goes_on) {
                    ASSERT_GT(cut, 150U) << "twelve saves are as many operations at least";
                    break;
                }
            }
            model.restore_power();
            Unit after{model};
            const Bytes found = after.content();
            ASSERT_TRUE(found == confirmed || found == attempted) << "seed " << seed << ", cut " << cut;
            // After the power cut, saves work as usual.
            ASSERT_TRUE(after.journal.prepare());
            ASSERT_TRUE(after.store(place(99), pattern(99)));
            ASSERT_EQ(Unit{model}.content(), with(found, place(99), pattern(99))) << "seed " << seed << ", cut " << cut;
        }
    }
}

/// Makes twelve saves on flash whose operation number `failure` (from 0) fails; `programs`: it programs its word all
/// the same. Expects that the content is at all times that of the confirmed saves. Returns how many saves failed.
std::size_t refused_saves(std::size_t failure, bool programs) {
    FlashModel model{1, small_sector};
    Unit unit{model};
    model.fail_each_after(failure, {programs});
    Bytes expected = blank();
    std::size_t refused = 0;
    for (std::size_t number = 1; number <= 12; ++number) {
        if (unit.store(place(number), pattern(number))) {
            expected = with(expected, place(number), pattern(number));
        } else {
            ++refused;
        }
        EXPECT_EQ(unit.content(), expected) << "failure " << failure << ", save " << number;
        EXPECT_EQ(Unit{model}.content(), expected) << "failure " << failure << ", power-on after save " << number;
    }
    return refused;
}

TEST(ParameterJournal, FailedFlashOperationKeepsTheCommittedContent) {
    verifies<req::CO_FLASH_001, req::CO_FLASH_003>();
    for (const bool programs : {false, true}) {
        std::size_t failure = 0;
        while (refused_saves(failure, programs) == 1 && !HasFailure()) {
            ++failure;
        }
        // From here on no operation fails: twelve saves need fewer operations.
        ASSERT_GT(failure, 150U);
        EXPECT_EQ(refused_saves(failure, programs), 0U);
    }
}

TEST(ParameterJournal, TwoFailedFlashOperationsLeaveTheOldOrTheNewContent) {
    verifies<req::CO_FLASH_005>();
    std::size_t new_contents = 0;
    for (std::size_t failure = 0; failure < 150; ++failure) {
        FlashModel model{1, small_sector};
        Unit unit{model};
        // Two operations report a failure: the first one has programmed its word all the same, the second one has not.
        model.fail_each_after(failure, {true, false});
        Bytes before = blank();
        std::size_t number = 1;
        for (; unit.store(place(number), pattern(number)); ++number) {
            before = with(before, place(number), pattern(number));
        }
        const Bytes found = Unit{model}.content();
        const bool is_new = found == with(before, place(number), pattern(number));
        ASSERT_TRUE(is_new || found == before) << "failure " << failure;
        EXPECT_EQ(unit.content(), found) << "failure " << failure;
        new_contents += is_new ? 1 : 0;
    }
    // A commit becomes valid at its last word: the CRC of its last slot, or the CRC of the sector's header.
    EXPECT_GE(new_contents, 9U);
}

TEST(ParameterJournal, WaitForABusyFlashIsBounded) {
    verifies<req::CO_FLASH_001, req::CO_FLASH_004>();
    FlashModel model;
    Unit unit{model};
    ASSERT_TRUE(unit.store(0, {1}));
    model.stay_busy(true);
    EXPECT_FALSE(unit.store(0, {2}));
    EXPECT_FALSE(unit.journal.prepare());
    EXPECT_EQ(unit.content(), with(blank(), 0, {1}));
    model.stay_busy(false);
    EXPECT_TRUE(unit.store(0, {3}));
    EXPECT_EQ(Unit{model}.content(), with(blank(), 0, {3}));
}

TEST(ParameterJournal, FlashCellThatDoesNotKeepItsBitsFailsTheCommit) {
    verifies<req::CO_FLASH_001, req::CO_FLASH_003>();
    FlashModel model;
    Unit unit{model};
    ASSERT_TRUE(unit.store(0, {1}));
    // The second word of the next slot is stuck at 0, so that slot is not blank. The journal uses the slot after it.
    model.sector(0).cells()[2 * 6 + 1] = 0;
    EXPECT_FALSE(unit.store(0, {2}));
    EXPECT_EQ(unit.content(), with(blank(), 0, {1}));
    EXPECT_TRUE(unit.store(0, {3}));
    EXPECT_EQ(Unit{model}.content(), with(blank(), 0, {3}));
}

TEST(ParameterJournal, DamagedSaveIsIgnoredAndTheSaveBeforeItIsRead) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    {
        Unit unit{model};
        ASSERT_TRUE(unit.store(0, {1}));
        ASSERT_TRUE(unit.store(0, {2}));
    }
    model.sector(0).cells()[2 * 6 + 1] ^= 0x10U;  // damages the slot of the second save
    EXPECT_EQ(Unit{model}.content(), with(blank(), 0, {1}));
}

TEST(ParameterJournal, UsedSlotThatReadsAsBlankIsNotTheEndOfTheJournal) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    {
        Unit unit{model};
        for (const std::uint8_t number : Bytes{1, 2, 3}) {
            ASSERT_TRUE(unit.store(0, {number}));
        }
    }
    // Programming that loses its power may leave a word with any value (RM0090 3.6). Here, all six words in the slot of
    // the second save read as blank.
    std::fill_n(model.sector(0).cells().begin() + 2 * 6, 6, 0xFFFFFFFFU);
    Unit unit{model};
    EXPECT_EQ(unit.content(), with(blank(), 0, {3}));
    EXPECT_TRUE(unit.store(0, {4}));
    EXPECT_EQ(Unit{model}.content(), with(blank(), 0, {4}));
}

TEST(Flash, FlashModelDetectsProgrammingOfALockedFlash) {
    verifies<req::CO_FLASH_001>();
    FlashModel model;
    Flash flash{model.registers(), 100};
    EXPECT_FALSE(flash.program(model.sectors()[0].words[0], 0));  // the flash is locked
    EXPECT_FALSE(model.faults().empty());
    EXPECT_EQ(model.sector(0).cells()[0], 0xFFFFFFFFU);
}

// RM0090 3.9.5: OPERR is bit 1 of FLASH_SR, WRPERR 4, PGAERR 5, PGPERR 6, PGSERR 7.
TEST(Flash, EachErrorFlagFailsTheOperation) {
    verifies<req::CO_FLASH_001>();
    for (const std::uint32_t flag : {1U, 4U, 5U, 6U, 7U}) {
        SCOPED_TRACE(flag);
        FlashModel model;
        Flash flash{model.registers(), 100};
        flash.begin();
        model.fail_after(0, 1U << flag, true);
        EXPECT_FALSE(flash.program(model.sectors()[0].words[0], 0x5AU));
        EXPECT_EQ(model.sector(0).cells()[0], 0x5AU);  // only the flag shows the failure
        EXPECT_TRUE(flash.program(model.sectors()[0].words[1], 0x5AU));
        model.fail_after(0, 1U << flag, true);
        EXPECT_FALSE(flash.erase(2));
        EXPECT_TRUE(flash.erase(2));
        EXPECT_THAT(model.faults(), IsEmpty());
    }
}

TEST(Flash, OperationThatDoesNotEndFails) {
    verifies<req::CO_FLASH_001, req::CO_FLASH_004>();
    FlashModel model;
    Flash flash{model.registers(), 100};
    flash.begin();
    model.hang_in_next_operation();
    EXPECT_FALSE(flash.program(model.sectors()[0].words[0], 0x5AU));
    EXPECT_EQ(model.sector(0).cells()[0], 0x5AU);  // only the flag BSY shows the failure
    model.stay_busy(false);
    EXPECT_TRUE(flash.program(model.sectors()[0].words[1], 0x5AU));
    model.hang_in_next_operation();
    EXPECT_FALSE(flash.erase(2));
    model.stay_busy(false);
    EXPECT_TRUE(flash.erase(2));
}

TEST(Flash, DataAreNotReadFromAStaleCache) {
    verifies<req::CO_FLASH_002>();
    FlashModel model;
    Unit unit{model};
    Register& word = model.sectors()[0].words[6];
    EXPECT_EQ(word.read(), 0xFFFFFFFFU);  // after this read, the word is in the data cache
    ASSERT_TRUE(unit.store(0, {1}));
    EXPECT_TRUE(model.caches_data());
    EXPECT_NE(word.read(), 0xFFFFFFFFU);
    EXPECT_THAT(model.faults(), IsEmpty());
}

}  // namespace canproof::test
