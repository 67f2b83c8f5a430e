// SPDX-License-Identifier: Apache-2.0
// The march test of RAM, with models of faulty memory cells. The test must find each fault, and RAM without a fault
// must keep its contents.
#include "target/stm32f405/selftest/ram_check.hpp"

#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/core_model.hpp"
#include "tests/support/stm32f405/ram_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using Fault = RamModel::Fault;
using Defect = RamModel::Defect;

// The RAM of 30 words is tested in nine slices of four words and one of three. Neighbouring slices share one word.
constexpr std::size_t word_count = 30;

/// Returns whether `passes` passes over the whole RAM find the defect. `stack`: first word of the second stack, and the
/// word behind it.
bool finds(const Defect& defect, std::uint32_t passes = 1, std::size_t words = word_count,
           std::pair<std::size_t, std::size_t> stack = {0, 0}) {
    RamModel ram{words};
    for (std::size_t i = 0; i < words; ++i) {
        ram.at(i) = static_cast<std::uint32_t>(0x9E3779B9U * i);
    }
    ram.set_defect(defect);
    RamCheck check{{ram.words(), stack.first, stack.second}};
    bool found = false;
    for (std::uint32_t i = 0; i < passes; ++i) {
        found = !check.pass() || found;
    }
    return found;
}

/// Returns every coupling fault in which a change or the state of the cell `aggressor` affects the cell `victim`.
std::vector<Defect> couplings(Cell aggressor, Cell victim) {
    std::vector<Defect> all;
    for (const bool edge : {false, true}) {
        all.push_back({Fault::inversion, victim, false, aggressor, edge});
        for (const bool value : {false, true}) {
            all.push_back({Fault::idempotent, victim, value, aggressor, edge});
            all.push_back({Fault::state, victim, value, aggressor, edge});
        }
    }
    return all;
}

}  // namespace

TEST(RamCheck, OnePassFindsEachStuckBitAndEachMissingTransition) {
    verifies<req::CO_SELF_001>();
    for (std::size_t word = 0; word < word_count; ++word) {
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            for (const bool value : {false, true}) {
                EXPECT_TRUE(finds({Fault::stuck, {word, bit}, value, {0, 0}, false})) << word << '.' << bit << value;
                EXPECT_TRUE(finds({Fault::transition, {word, bit}, value, {0, 0}, false}))
                    << word << '.' << bit << value;
            }
        }
    }
}

TEST(RamCheck, OnePassFindsCouplingBetweenNeighbouringWords) {
    verifies<req::CO_SELF_001>();
    for (std::size_t word = 0; word + 1 < word_count; ++word) {
        for (const std::uint32_t bit : {0U, 13U, 31U}) {
            for (const std::uint32_t other : {0U, 13U, 30U}) {
                for (const bool upwards : {false, true}) {
                    const Cell first{word, bit}, second{word + 1, other};
                    for (const Defect& one : couplings(upwards ? first : second, upwards ? second : first)) {
                        EXPECT_TRUE(finds(one))
                            << word << '.' << bit << ' ' << other << ' ' << upwards << static_cast<int>(one.fault);
                    }
                }
            }
        }
    }
}

TEST(RamCheck, OnePassFindsAWriteThatAlsoReachesANeighbouringWord) {
    verifies<req::CO_SELF_001>();
    for (std::size_t word = 0; word + 1 < word_count; ++word) {
        EXPECT_TRUE(finds({Fault::address, {word + 1, 0}, false, {word, 0}, false})) << word;
        EXPECT_TRUE(finds({Fault::address, {word, 0}, false, {word + 1, 0}, false})) << word;
    }
}

TEST(RamCheck, SixPassesFindCouplingBetweenTheBitsOfAWord) {
    verifies<req::CO_SELF_001>();
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        for (std::uint32_t other = 0; other < 32; ++other) {
            if (bit == other) {
                continue;
            }
            for (const Defect& one : couplings({1, bit}, {1, other})) {
                EXPECT_TRUE(finds(one, RamCheck::background_count, 3))
                    << bit << ' ' << other << ' ' << static_cast<int>(one.fault);
            }
        }
    }
}

TEST(RamCheck, FaultFreeRamKeepsItsContentsInEachPass) {
    verifies<req::CO_SELF_001, req::CO_SELF_014>();
    RamModel ram{word_count};
    for (std::size_t i = 0; i < word_count; ++i) {
        ram.at(i) = static_cast<std::uint32_t>(0x9E3779B9U * i);
    }
    RamCheck check{{ram.words(), 0, 0}};
    for (std::uint32_t pass = 0; pass < 2 * RamCheck::background_count; ++pass) {
        EXPECT_EQ(check.passes(), pass);
        EXPECT_TRUE(check.pass());
        for (std::size_t i = 0; i < word_count; ++i) {
            EXPECT_EQ(ram.at(i), static_cast<std::uint32_t>(0x9E3779B9U * i));
        }
    }
}

TEST(RamCheck, InterruptsAreMaskedDuringTheTestOfASliceOnly) {
    verifies<req::CO_SELF_001, req::CO_SELF_013>();
    RamModel ram{word_count};
    RamCheck check{{ram.words(), 0, 0}};
    std::size_t before = 0;
    for (std::uint32_t slice = 0; slice < 9; ++slice) {  // slices of words 0 to 3, 3 to 6 … 24 to 27
        EXPECT_TRUE(check.step());
        // For each of four words there are 13 accesses: one saves it, ten are those of March C-, one restores it, one
        // checks it.
        EXPECT_EQ(ram.accesses() - before, 13U * 4U);
        before = ram.accesses();
        EXPECT_FALSE(core_model().masked);
        EXPECT_EQ(check.passes(), 0U);
    }
    EXPECT_TRUE(check.step());  // the last slice: words 27 to 29
    EXPECT_EQ(ram.accesses() - before, 13U * 3U);
    EXPECT_EQ(check.passes(), 1U);
    EXPECT_EQ(ram.unmasked(), 0U);
    core_model().masked = true;  // interrupts that the caller has masked stay masked
    EXPECT_TRUE(check.step());
    EXPECT_TRUE(core_model().masked);
    core_model() = CoreModel{};
}

TEST(RamCheck, MarchTestRunsOnAStackOutsideTheTestedSlice) {
    verifies<req::CO_SELF_001>();
    RamModel ram{word_count};
    core_model() = CoreModel{};
    RamCheck check{{ram.words(), 10, 16}};
    // Words 10 to 15 are a second stack, on which the test of a slice runs. Slices 0 to 3, 3 to 6, 6 to 9 and 18 to 21
    // are tested on it. Slices 9 to 12, 12 to 15 and 15 to 18 contain its words, so they are not.
    for (const std::uint32_t marches : {1U, 2U, 3U, 3U, 3U, 3U, 4U}) {
        EXPECT_TRUE(check.step());
        EXPECT_EQ(core_model().marches, marches);
    }
    EXPECT_EQ(core_model().stack_end, &ram.words()[16]);
    core_model() = CoreModel{};
}

TEST(RamCheck, SliceThatBeginsBehindTheSecondStackIsTestedOnIt) {
    verifies<req::CO_SELF_001>();
    RamModel ram{word_count};
    core_model() = CoreModel{};
    RamCheck check{{ram.words(), 10, 15}};
    for (const std::uint32_t marches : {1U, 2U, 3U, 3U, 3U, 4U}) {  // slices 0 to 3, 3 to 6 … 15 to 18
        EXPECT_TRUE(check.step());
        EXPECT_EQ(core_model().marches, marches);
    }
    core_model() = CoreModel{};
}

TEST(RamCheck, WordsOfTheSecondStackAreTestedWithEachBackground) {
    verifies<req::CO_SELF_001>();
    for (std::size_t word = 10; word < 16; ++word) {
        EXPECT_TRUE(finds({Fault::stuck, {word, 7}, true, {0, 0}, false}, 1, word_count, {10, 16}));
        for (const std::uint32_t other : {0U, 1U, 2U, 4U, 8U, 16U}) {  // each differs from bit 3 in another background
            for (const Defect& one : couplings({word, other}, {word, 3})) {
                EXPECT_TRUE(finds(one, RamCheck::background_count, word_count, {10, 16})) << word << '.' << other;
            }
        }
    }
}

TEST(RamCheck, SecondPassBeginsAtTheFirstWordAgain) {
    verifies<req::CO_SELF_001>();
    RamModel ram{word_count};
    RamCheck check{{ram.words(), 0, 0}};
    EXPECT_TRUE(check.pass());
    ram.set_defect({Fault::stuck, {0, 5}, true, {0, 0}, false});
    EXPECT_FALSE(check.pass());
}

TEST(RamCheck, RamOfOneWordIsTested) {
    verifies<req::CO_SELF_001>();
    EXPECT_TRUE(finds({Fault::stuck, {0, 31}, true, {0, 0}, false}, 1, 1));
}

TEST(RamCheck, WordThatDoesNotTakeItsContentsBackIsAFailure) {
    verifies<req::CO_SELF_014>();
    // 44 accesses save four words and test them; four more restore them. Only then bit 9 of word 2 sticks.
    for (const std::size_t from : {44U, 48U}) {
        RamModel ram{4};
        ram.set_defect({Fault::stuck, {2, 9}, true, {0, 0}, false}, from);
        RamCheck check{{ram.words(), 0, 0}};
        EXPECT_FALSE(check.step()) << from;
    }
}

}  // namespace canproof::test
