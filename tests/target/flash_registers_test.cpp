// SPDX-License-Identifier: Apache-2.0
// Tests what the flash driver writes to the registers of the flash controller, as values of RM0090 3.9, and that it
// leaves them alone while the controller is busy.
#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/flash.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/register_record.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

// Offsets of the registers: RM0090 3.9. The words of a sector follow at `at_words`.
constexpr std::size_t at_acr = 0x00, at_keyr = 0x04, at_sr = 0x0C, at_cr = 0x10, at_words = 0x1000;
using WordBlock = std::array<Register, 6>;

struct RecordedFlash {
    FlashModel model;
    RegisterRecord record;
    Flash flash;

    explicit RecordedFlash(std::uint32_t most_polls = 100) : flash{model.registers(), most_polls} {
        record.watch(model.registers());
        record.watch(words(), at_words);
    }
    WordBlock& words() { return reinterpret_cast<WordBlock&>(model.sectors()[0].words[0]); }
    bool program(std::size_t word, std::uint32_t value) { return flash.program(words().at(word), value); }
};

}  // namespace

// LOCK is bit 31 of FLASH_CR. The keys are those of RM0090 3.6.1; DCEN is bit 10 of FLASH_ACR, and DCRST bit 12.
TEST(FlashRegisters, FlashIsUnlockedByItsKeysOnceAndLockedAgain) {
    verifies<req::CO_FLASH_001, req::CO_FLASH_002>();
    RecordedFlash bench;
    bench.flash.begin();
    EXPECT_THAT(bench.record.writes(),
                ElementsAre(Pair(at_acr, 0), Pair(at_keyr, 0x45670123), Pair(at_keyr, 0xCDEF89AB)));
    bench.flash.begin();
    EXPECT_EQ(bench.record.writes_to(at_keyr).size(), 2U);  // a key for an open flash would be a wrong one
    bench.record.clear();
    bench.flash.finish();
    EXPECT_THAT(bench.record.writes_to(at_cr), ElementsAre(0x80000000));
    // the data cache is cleared while it is off (3.5.2)
    EXPECT_THAT(bench.record.writes_to(at_acr), ElementsAre(0x1000, 0, 0x400));
    EXPECT_EQ(bench.record.writes().size(), 4U);
    EXPECT_TRUE(bench.model.is_locked());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// RM0090 3.6.3: SER (bit 1 of FLASH_CR) and the number of the sector (SNB, bits 6 to 3) are set before STRT (bit 16).
// PSIZE (bits 9 and 8) is 2 for words. A 1 in bits 0, 1 and 4 to 7 of FLASH_SR clears the flags of the last operation.
TEST(FlashRegisters, EraseSelectsTheSectorBeforeItStarts) {
    verifies<req::CO_FLASH_001>();
    for (const std::uint32_t sector : {2U, 3U}) {
        RecordedFlash bench;
        bench.flash.begin();
        bench.record.clear();
        EXPECT_TRUE(bench.flash.erase(sector));
        const std::uint32_t command = 0x202 | (sector << 3U);
        EXPECT_THAT(bench.record.writes(), ElementsAre(Pair(at_sr, 0xF3), Pair(at_cr, command),
                                                       Pair(at_cr, command | 0x10000), Pair(at_cr, 0)));
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

// RM0090 3.6.4: PG (bit 0 of FLASH_CR) is set before the word is written; it is cleared behind it, so that no later
// write programs a word.
TEST(FlashRegisters, WordIsWrittenWhileProgrammingIsOn) {
    verifies<req::CO_FLASH_001>();
    RecordedFlash bench;
    bench.flash.begin();
    bench.record.clear();
    EXPECT_TRUE(bench.program(5, 0x12345678));
    EXPECT_THAT(bench.record.writes(),
                ElementsAre(Pair(at_sr, 0xF3), Pair(at_cr, 0x201), Pair(at_words + 20, 0x12345678), Pair(at_cr, 0)));
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

// A write to FLASH_CR while BSY is set would stop the processor until the flash is ready (RM0090 3.6.1).
TEST(FlashRegisters, BusyFlashIsNotWritten) {
    verifies<req::CO_FLASH_004>();
    RecordedFlash bench;
    bench.flash.begin();
    bench.model.stay_busy(true);
    bench.record.clear();
    EXPECT_FALSE(bench.flash.erase(2));
    EXPECT_FALSE(bench.program(0, 5));
    EXPECT_THAT(bench.record.writes(), IsEmpty());
    bench.flash.finish();
    EXPECT_THAT(bench.record.writes_to(at_cr), IsEmpty());
    EXPECT_TRUE(bench.model.caches_data());
}

TEST(FlashRegisters, ControlRegisterOfAnOperationThatDoesNotEndIsNotWritten) {
    verifies<req::CO_FLASH_004>();
    RecordedFlash bench;
    bench.flash.begin();
    bench.model.hang_in_next_operation();
    EXPECT_FALSE(bench.program(0, 5));
    EXPECT_EQ(bench.record.writes().back(), RegisterRecord::One(at_words, 5));
    bench.model.stay_busy(false);
    bench.model.hang_in_next_operation();
    EXPECT_FALSE(bench.flash.erase(2));
    EXPECT_EQ(bench.record.writes().back(), RegisterRecord::One(at_cr, 0x10212));
    bench.flash.finish();
    EXPECT_THAT(bench.model.faults(), IsEmpty());
    bench.model.stay_busy(false);
    bench.flash.begin();
    EXPECT_TRUE(bench.program(0, 5));
    bench.flash.finish();
    EXPECT_TRUE(bench.model.is_locked());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(FlashRegisters, FlashIsPolledAsOftenAsTheLimitSays) {
    verifies<req::CO_FLASH_004>();
    EXPECT_EQ(Flash::usual_polls, 20000000U);
    for (const std::uint32_t polls : {1U, 2U, 5U}) {
        RecordedFlash bench{polls};
        bench.flash.begin();
        bench.model.stay_busy(true);
        bench.record.clear();
        EXPECT_FALSE(bench.flash.erase(2));
        EXPECT_EQ(bench.record.reads_of(at_sr), polls);
    }
}

}  // namespace canproof::test
