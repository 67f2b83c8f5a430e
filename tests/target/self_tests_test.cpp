// SPDX-License-Identifier: Apache-2.0
// Tests the self-tests of flash, stack, program flow, clock and outputs, each with the faults that it must find.
#include "target/stm32f405/selftest/self_tests.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/flow_monitor.hpp"
#include "target/stm32f405/selftest/output_copy.hpp"
#include "target/stm32f405/selftest/state_guard.hpp"
#include "tests/support/stm32f405/capture_model.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/ram_model.hpp"
#include "tests/support/stm32f405/sealed_flash.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::IsEmpty;

/// Runs steps of the check until one more pass over the flash is complete. Returns whether all steps succeeded.
bool pass_over(FlashCheck& check) {
    const std::uint32_t before = check.passes();
    bool sound = true;
    while (check.passes() == before) {
        sound = check.step() && sound;
    }
    return sound;
}

const std::vector<Step> pass_steps{Step::bus, Step::inputs, Step::device, Step::transmit, Step::outputs, Step::tests};

bool is_pass(const std::vector<Step>& steps) {
    FlowMonitor flow;
    for (const Step step : steps) {
        flow.note(step);
    }
    return flow.end();
}

struct ClockCheckBench {
    CaptureModel model;
    ClockCheck check{model.registers(), 80};
    Instant now{0};

    ClockCheckBench() { check.start(now); }
    /// Runs passes of the main loop, each of which really takes `us` microseconds. Returns how many succeeded before
    /// the first failure.
    int run(int passes, double us = 50) {
        for (int i = 0; i < passes; ++i) {
            model.pass(us);
            // the time base counts the timer's clock, which should be 80 MHz
            now.us += static_cast<std::uint64_t>(us * model.timer_mhz / 80);
            if (!check.step(now)) {
                return i;
            }
        }
        return passes;
    }
};

}  // namespace

TEST(FlashCheck, OnePassFindsEachFlippedBit) {
    verifies<req::CO_SELF_002>();
    SealedFlash flash{72, 100};
    FlashCheck check{flash.vectors(), flash.image()};
    EXPECT_TRUE(pass_over(check));
    for (std::size_t at = 0; at < flash.size(); ++at) {
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
            flash.turn(at, bit);
            EXPECT_FALSE(pass_over(check)) << at << '.' << bit;
            flash.turn(at, bit);
        }
    }
    EXPECT_TRUE(pass_over(check));
}

TEST(FlashCheck, FlashCheckPassTakesOneStepForEach16Bytes) {
    verifies<req::CO_SELF_002>();
    SealedFlash flash{72, 100};
    FlashCheck check{flash.vectors(), flash.image()};
    // 72 bytes of vectors take four steps of 16 bytes and one of 8. The code with its CRC, 104 bytes, takes six steps
    // of 16 bytes and one of 8.
    for (int step = 0; step < 12; ++step) {
        EXPECT_EQ(check.passes(), 0U);
        EXPECT_TRUE(check.step());
    }
    EXPECT_EQ(check.passes(), 1U);
}

TEST(FlashCheck, DamageInASliceThatWasAlreadyCheckedIsFoundInTheNextPass) {
    verifies<req::CO_SELF_002>();
    SealedFlash flash{72, 100};
    FlashCheck check{flash.vectors(), flash.image()};
    EXPECT_TRUE(check.step());
    flash.turn(3, 5);
    EXPECT_TRUE(pass_over(check));
    EXPECT_FALSE(pass_over(check));
}

TEST(StackGuard, GuardNoticesEachChangedBit) {
    verifies<req::CO_SELF_004>();
    RamModel ram{8};
    StackGuard guard{ram.words()};
    EXPECT_FALSE(guard.is_intact());
    guard.start();
    EXPECT_TRUE(guard.is_intact());
    for (std::size_t word = 0; word < 8; ++word) {
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            ram.at(word) ^= 1U << bit;
            EXPECT_FALSE(guard.is_intact());
            ram.at(word) ^= 1U << bit;
        }
    }
    EXPECT_TRUE(guard.is_intact());
}

TEST(FlowMonitor, OnlyOneOfAllSequencesOfUpToSixStepsIsAValidLoopPass) {
    verifies<req::CO_SELF_005>();
    std::size_t tried = 0;
    for (std::size_t length = 0, count = 1; length <= 6; ++length, count *= 6) {
        for (std::size_t number = 0; number < count; ++number, ++tried) {
            std::vector<Step> steps;
            for (std::size_t i = 0, rest = number; i < length; ++i, rest /= 6) {
                steps.push_back(pass_steps.at(rest % 6));
            }
            EXPECT_EQ(is_pass(steps), steps == pass_steps);
        }
    }
    EXPECT_EQ(tried, 55987U);  // 1 + 6 + 6² + … + 6⁶ = (6^7 - 1) / 5
}

TEST(FlowMonitor, LoopPassWithAnExtraStepIsInvalid) {
    verifies<req::CO_SELF_005>();
    for (std::size_t at = 0; at <= 6; ++at) {
        for (const Step more : pass_steps) {
            std::vector<Step> steps = pass_steps;
            steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(at), more);
            EXPECT_FALSE(is_pass(steps));
        }
    }
}

/// A search backwards from the signature of a correct pass found these sequences. With the next lower or the next
/// higher number as the factor of the signature, they would have this signature. Both numbers are even.
TEST(FlowMonitor, SequenceThatAnEvenFactorWouldAcceptIsInvalid) {
    verifies<req::CO_SELF_005>();
    for (const std::vector<int>& numbers :
         {std::vector<int>{2, 2, 6, 4, 4, 4, 1, 2, 5, 1, 1, 6}, {3, 5, 1, 4, 1, 6, 3, 2, 1, 2, 3, 2}}) {
        std::vector<Step> steps;
        for (const int number : numbers) {
            steps.push_back(static_cast<Step>(number));
        }
        EXPECT_FALSE(is_pass(steps));
    }
}

TEST(FlowMonitor, LoopPassAfterAnInvalidPassIsInvalid) {
    verifies<req::CO_SELF_005>();
    FlowMonitor flow;
    const auto pass = [&flow] {
        for (const Step step : pass_steps) {
            flow.note(step);
        }
        return flow.end();
    };
    EXPECT_TRUE(pass());
    EXPECT_TRUE(pass());
    EXPECT_FALSE(flow.end());
    EXPECT_FALSE(pass());
    EXPECT_FALSE(pass());
}

TEST(OutputCopy, CopyNoticesEachFlippedBitOfTheOutputsAndOfTheCopy) {
    verifies<req::CO_SELF_007>();
    struct Outputs {
        std::array<float, 2> volts{1.5F, -3.0F};
        std::array<bool, 4> on{true, false, true, false};
    };
    Outputs outputs;
    OutputCopy<Outputs> copy;
    EXPECT_FALSE(copy.matches(outputs));
    copy.keep(outputs);
    EXPECT_TRUE(copy.matches(outputs));
    const auto turn = [](void* object, std::size_t at, std::uint32_t bit) {
        static_cast<unsigned char*>(object)[at] ^= static_cast<unsigned char>(1U << bit);
    };
    for (std::size_t at = 0; at < sizeof outputs.volts; ++at) {
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
            turn(outputs.volts.data(), at, bit);
            EXPECT_FALSE(copy.matches(outputs));
            turn(outputs.volts.data(), at, bit);
        }
    }
    for (std::size_t at = 0; at < sizeof copy; ++at) {
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
            turn(&copy, at, bit);
            EXPECT_FALSE(copy.matches(outputs));
            turn(&copy, at, bit);
        }
    }
    for (bool& one : outputs.on) {
        one = !one;
        EXPECT_FALSE(copy.matches(outputs));
        one = !one;
    }
    EXPECT_TRUE(copy.matches(outputs));
}

TEST(OutputCopy, CopyOfThreeBytesNoticesEachFlippedBit) {
    verifies<req::CO_SELF_007>();
    // the outputs of the AX188001, three bytes, are less than one 32-bit word
    std::array<std::uint8_t, 3> outputs{60, 128, 128};
    OutputCopy<std::array<std::uint8_t, 3>> copy;
    copy.keep(outputs);
    EXPECT_TRUE(copy.matches(outputs));
    for (std::uint8_t& output : outputs) {
        for (std::uint32_t bit = 0; bit < 8; ++bit) {
            output ^= static_cast<std::uint8_t>(1U << bit);
            EXPECT_FALSE(copy.matches(outputs)) << bit;
            output ^= static_cast<std::uint8_t>(1U << bit);
        }
    }
    EXPECT_TRUE(copy.matches(outputs));
}

TEST(StateGuard, GuardNoticesEachFlippedBit) {
    verifies<req::CO_SELF_011>();
    // core_sum() adds the 11 words as one group of eight and three single words.
    std::array<std::uint32_t, 11> words{};
    std::iota(words.begin(), words.end(), 0xFFFFFFFAU);
    StateGuard guard{object_bytes(words)};
    guard.keep();
    EXPECT_TRUE(guard.matches());
    for (std::uint32_t& word : words) {
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            word ^= 1U << bit;
            EXPECT_FALSE(guard.matches()) << bit;
            word ^= 1U << bit;
        }
    }
    EXPECT_TRUE(guard.matches());
}

TEST(StateGuard, GuardNoticesSwappedWords) {
    verifies<req::CO_SELF_011>();
    std::array<std::uint32_t, 10> words{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    StateGuard guard{object_bytes(words)};
    guard.keep();
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        std::swap(words[i], words[i + 1]);
        EXPECT_FALSE(guard.matches()) << i;
        std::swap(words[i], words[i + 1]);
    }
}

TEST(StateGuard, ChecksumIsRotatedByOneBitBeforeTheNextWordIsAdded) {
    verifies<req::CO_SELF_011>();
    const std::array<std::uint32_t, 3> words{0x80000001, 0x00000010, 0xFFFFFFFF};
    // 80000001h rotated is 00000003h; plus 10h gives 00000013h; rotated 00000026h; plus FFFFFFFFh (-1) gives 00000025h
    EXPECT_EQ(StateGuard{object_bytes(words)}.sum(), 0x25U);
}

TEST(ClockCheck, OscillatorFrom17To47KilohertzIsAccepted) {
    verifies<req::CO_SELF_006>();
    for (const double khz : {17.0, 25.0, 32.0, 47.0}) {
        ClockCheckBench bench;
        bench.model.oscillator_khz = khz;
        EXPECT_EQ(bench.run(40000), 40000) << khz;  // 40,000 passes of 50 µs are 2 s
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

TEST(ClockCheck, ClockFarFromItsPlannedFrequencyIsNoticedWithinAMillisecond) {
    verifies<req::CO_SELF_006>();
    // 8 periods at 32 kHz are 250 µs. A clock of f times its planned frequency measures them as 250 f µs: 167.5 µs at
    // 0.67, 475 µs at 1.9. Allowed are 170 to 471 µs: 8 periods at 47 to 17 kHz.
    for (const double factor : {0.1, 0.5, 0.67, 1.9, 3.0}) {
        ClockCheckBench bench;
        EXPECT_EQ(bench.run(1000), 1000);
        bench.model.timer_mhz = 80 * factor;
        EXPECT_LT(bench.run(1000), 20) << factor;  // passes of 50 µs
    }
    // Factors of 0.69 and 1.87 give 172.5 and 467.5 µs, which are within the limits.
    for (const double factor : {0.69, 1.87}) {
        ClockCheckBench bench;
        bench.model.timer_mhz = 80 * factor;
        EXPECT_EQ(bench.run(1000), 1000) << factor;
    }
}

TEST(ClockCheck, OscillatorOutside17To47KilohertzIsAFailure) {
    verifies<req::CO_SELF_006>();
    for (const double khz : {16.9, 47.2}) {
        ClockCheckBench bench;
        bench.model.oscillator_khz = khz;
        EXPECT_LT(bench.run(1000), 1000) << khz;
    }
}

TEST(ClockCheck, ClockErrorBeyondTheTolerancesIsNoticedAtEachOscillatorFrequency) {
    verifies<req::CO_SELF_006>();
    for (double khz = 17; khz <= 47; khz += 1) {
        // 17 / 47 = 0.362 and 47 / 17 = 2.765
        for (const double factor : {0.36, 2.77}) {
            ClockCheckBench bench;
            bench.model.oscillator_khz = khz;
            bench.model.timer_mhz = 80 * factor;
            EXPECT_LT(bench.run(1000), 1000) << khz << ' ' << factor;
        }
    }
}

TEST(ClockCheck, StoppedOscillatorIsNoticedAfter100Milliseconds) {
    verifies<req::CO_SELF_015>();
    ClockCheckBench bench;
    EXPECT_EQ(bench.run(1000), 1000);
    bench.model.oscillator_khz = 0;
    const int passes = bench.run(10000);
    EXPECT_GE(passes, 1990);  // a failure after about 100 ms, 2000 passes of 50 µs; the last capture was up to 250 µs
                              // before them
    EXPECT_LE(passes, 2000);
}

TEST(ClockCheck, LoopPassLongerThanACaptureIntervalIsNoFailure) {
    verifies<req::CO_SELF_006, req::CO_SELF_015>();
    ClockCheckBench bench;
    EXPECT_EQ(bench.run(200, 900), 200);  // a pass of 900 µs misses captures, which come every 250 µs
    EXPECT_EQ(bench.run(1, 500000), 1);   // a pass of 500 ms, as long as an erase of the flash takes
    EXPECT_EQ(bench.run(1000), 1000);
    bench.model.timer_mhz = 800;
    EXPECT_LT(bench.run(1000), 20);
}

TEST(ClockCheck, TimerCaptureBetweenTwoRegisterReadsIsNoFailure) {
    verifies<req::CO_SELF_006>();
    ClockCheckBench bench;
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(bench.run(7), 7);
        bench.model.capture_before_read();
    }
}

}  // namespace canproof::test
