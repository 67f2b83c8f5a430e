// SPDX-License-Identifier: Apache-2.0
// Tests the clock tree, the time base, the watchdog and the check of the firmware image, with models of their
// registers.
#include "target/stm32f405/clock.hpp"

#include <gmock/gmock.h>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/image_check.hpp"
#include "target/stm32f405/time_base.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::IsEmpty;

struct ClockBench {
    ClockModel model;
    Clock clock{model.registers(), model.power(), model.flash(), 100};
};

constexpr std::size_t timer_counter = 0x24;

}  // namespace

TEST(Clock, CoreRunsFromTheCrystal) {
    verifies<req::CO_CLOCK_001>();
    struct Row {
        ClockPlan plan;
        double core, apb1;
    };
    for (const Row& row : {Row{core_168_mhz, 168, 42}, {core_160_mhz, 160, 40}}) {
        ClockBench bench;
        EXPECT_EQ(bench.clock.start(row.plan), ClockSource::crystal);
        EXPECT_EQ(bench.model.core_mhz(), row.core);
        EXPECT_EQ(bench.model.apb1_mhz(), row.apb1);
        EXPECT_EQ(row.plan.apb1_hz(), row.apb1 * 1e6);
        EXPECT_EQ(row.plan.timer_mhz(),
                  2 * row.apb1);  // RM0090 7.2: a timer's clock is twice that of its bus if the bus clock is divided
        EXPECT_TRUE(bench.model.is_crystal_watched());
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

TEST(Clock, CoreRunsFromTheInternalOscillatorWithoutACrystal) {
    verifies<req::CO_CLOCK_003>();
    ClockBench bench;
    bench.model.break_crystal();
    EXPECT_EQ(bench.clock.start(core_168_mhz), ClockSource::internal);
    EXPECT_EQ(bench.model.core_mhz(), 168);
    EXPECT_FALSE(bench.model.is_crystal_watched());
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(Clock, PllThatDoesNotLockIsReported) {
    verifies<req::CO_CLOCK_004>();
    ClockBench bench;
    bench.model.break_pll();
    EXPECT_EQ(bench.clock.start(core_168_mhz), ClockSource::none);
    EXPECT_EQ(bench.model.core_mhz(), 16);
    EXPECT_THAT(bench.model.faults(), IsEmpty());
}

TEST(Clock, ResetByTheWatchdogIsReportedOnce) {
    verifies<req::CO_D_SELF_001>();
    ClockBench bench;
    EXPECT_FALSE(bench.clock.take_watchdog_reset());
    bench.model.reset_by_watchdog();
    EXPECT_TRUE(bench.clock.take_watchdog_reset());
    EXPECT_FALSE(bench.clock.take_watchdog_reset());
}

TEST(TimeBase, TimeBaseContinuesAcrossEachOverflowOfThe32BitTimer) {
    verifies<req::CO_CLOCK_002>();
    PlainModel<TimerRegisters> timer;
    TimeBase time{timer.registers(), 84};
    time.start();
    EXPECT_EQ(timer.at(0x28), 83U);          // 84 MHz / 84 gives 1 us
    EXPECT_EQ(timer.at(0x2C), 0xFFFFFFFFU);  // the timer counts up to its greatest 32-bit value
    EXPECT_EQ(timer.at(0x14), 1U);           // an update event, so that the prescaler takes effect at once
    EXPECT_EQ(timer.at(0x00) & 1U, 1U);
    std::uint64_t expected = 0;
    for (const std::uint64_t step : {0ULL, 1ULL, 4294967294ULL, 1ULL, 4000000000ULL, 4000000000ULL, 4294967295ULL}) {
        expected += step;
        timer.at(timer_counter) = static_cast<std::uint32_t>(expected);
        EXPECT_EQ(time.now().us, expected);
    }
    EXPECT_GT(expected, 3ULL << 32U);
    time.start();
    EXPECT_EQ(time.now().us, 0U);
}

TEST(Watchdog, WatchdogResetsASecondAfterTheLastRefresh) {
    verifies<req::CO_WATCHDOG_001>();
    WatchdogModel model;
    Watchdog watchdog{model.registers(), 100};
    EXPECT_TRUE(watchdog.start());
    EXPECT_TRUE(model.is_running());
    for (int i = 0; i < 10; ++i) {
        model.pass(999);
        watchdog.refresh();
    }
    EXPECT_FALSE(model.has_bitten());
    model.pass(1001);
    EXPECT_TRUE(model.has_bitten());
    EXPECT_THAT(model.faults(), IsEmpty());
}

TEST(Watchdog, WatchdogWithItsFastestOscillatorOutlastsAFlashErase) {
    verifies<req::CO_WATCHDOG_001>();
    WatchdogModel model;
    Watchdog watchdog{model.registers(), 100};
    ASSERT_TRUE(watchdog.start());
    model.pass(500, 47);  // data sheet: erasing 16 KiB takes up to 500 ms; the watchdog's oscillator has 17 to 47 kHz
    EXPECT_FALSE(model.has_bitten());
    model.pass(1400, 17);
    EXPECT_TRUE(model.has_bitten());
}

TEST(Watchdog, WatchdogStartDoesNotWaitForAStoppedOscillator) {
    verifies<req::CO_WATCHDOG_003>();
    WatchdogModel model;
    Watchdog watchdog{model.registers(), 100};
    model.stay_updating(true);
    EXPECT_FALSE(watchdog.start());
    EXPECT_TRUE(model.is_running());
}

TEST(ImageCheck, ImageIsValidOnlyWithTheCrcOfItsVectorsAndCode) {
    verifies<req::CO_IMAGE_001>();
    // The check value: the CRC-32/ISO-HDLC of the text "123456789" is CBF43926h.
    const std::array<std::uint8_t, 4> vectors{'1', '2', '3', '4'};
    std::array<std::uint8_t, 9> image{'5', '6', '7', '8', '9', 0x26, 0x39, 0xF4, 0xCB};
    EXPECT_TRUE(is_sound_image(ByteView{vectors}, ByteView{image}));
    for (std::uint8_t& byte : image) {
        byte ^= 1U;
        EXPECT_FALSE(is_sound_image(ByteView{vectors}, ByteView{image}));
        byte ^= 1U;
    }
    EXPECT_FALSE(is_sound_image(ByteView{}, ByteView{image}));
    EXPECT_FALSE(is_sound_image(ByteView{vectors}, ByteView{}));
}

// The CRC of "123456789" follows: at the end of the vectors, and as all that the image has.
TEST(ImageCheck, ImageWithoutCodeIsNotSoundAlthoughTheCrcIsRight) {
    verifies<req::CO_IMAGE_001>();
    const std::array<std::uint8_t, 13> all{'1', '2', '3', '4', '5', '6', '7', '8', '9', 0x26, 0x39, 0xF4, 0xCB};
    EXPECT_FALSE(is_sound_image(ByteView{all}, ByteView{}));
    EXPECT_FALSE(is_sound_image(ByteView{all.data(), 9}, ByteView{all.data() + 9, 4}));
    EXPECT_TRUE(is_sound_image(ByteView{all.data(), 8}, ByteView{all.data() + 8, 5}));
}

}  // namespace canproof::test
