// SPDX-License-Identifier: Apache-2.0
// The exact writes of the drivers to the registers of the STM32F405: the addresses of RM0090 2.3, and values that are
// written out bit by bit from RM0090. Where the hardware permits any order of writes, the test permits it too.
#include <gmock/gmock.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;
using testing::ElementsAre;
using testing::IsEmpty;
using Writes = std::vector<Write>;

constexpr std::uintptr_t tim2_base = 0x40000000, tim3_base = 0x40000400, iwdg_base = 0x40003000, can1_base = 0x40006400,
                         pwr_base = 0x40007000, adc1_base = 0x40012000, gpiob_base = 0x40020400, rcc_base = 0x40023800,
                         flash_base = 0x40023C00, nvic_base = 0xE000E100;

/// Sorts the writes from `first` on, before `end`, by address: the hardware permits any order of them.
Writes in_any_order(Writes writes, std::size_t first, std::size_t end) {
    end = std::min(end, writes.size());
    std::sort(writes.begin() + static_cast<std::ptrdiff_t>(std::min(first, end)),
              writes.begin() + static_cast<std::ptrdiff_t>(end),
              [](const Write& a, const Write& b) { return a.address < b.address; });
    return writes;
}

/// The clock driver with models of its peripherals at their addresses.
struct ClockAtItsAddresses {
    // RCC_APB1ENR: PWREN (28), without which PWR_CR ignores writes. PWR_CR: VOS (14). RCC_CR: HSEON (16), HSION and
    // HSITRIM as after the reset (83h). FLASH_ACR: LATENCY 5, PRFTEN (8), ICEN (9), DCEN (10).
    static constexpr Write power_on{rcc_base + 0x40, 1U << 28U};
    static constexpr Write voltage{pwr_base, 1U << 14U};
    static constexpr Write crystal_on{rcc_base, 0x83U | 1U << 16U};
    static constexpr Write wait_states{flash_base, 5U | 1U << 8U | 1U << 9U | 1U << 10U};
    // RCC_CFGR: PPRE1 = 101 (divides by 4, bits 10 to 12), PPRE2 = 100 (by 2, bits 13 to 15); then SW = 2 (the PLL). A
    // new divider takes up to 16 cycles, so it precedes the switch (RM0090 7.3.3).
    static constexpr Write dividers{rcc_base + 0x08, 5U << 10U | 4U << 13U};
    static constexpr Write to_pll{rcc_base + 0x08, 5U << 10U | 4U << 13U | 2U};

    ClockModel model;
    Window at_power{pwr_base, model.power()};
    Window at_clock{rcc_base, model.registers()};
    Window at_flash{flash_base, model.flash()};
    AccessLog log;
    Clock clock{registers_at<ClockRegisters>(rcc_base), registers_at<PowerRegisters>(pwr_base),
                registers_at<FlashRegisters>(flash_base), 100};

    /// Returns the writes of start(), with the result of the call.
    std::pair<ClockSource, Writes> start(const ClockPlan& plan) {
        const ClockSource source = clock.start(plan);
        // PWR_CR, RCC_CR (crystal on) and FLASH_ACR: all three precede the PLL, for which the voltage must be set and
        // the flash must be slow enough (RM0090 3.5.1, 5.4.1).
        return {source, in_any_order(log.take_writes(), 1, 4)};
    }
};

}  // namespace

// RCC_PLLCFGR: PLLM in bits 0 to 5, PLLN in 6 to 14, PLLP = 0 (divides by 2) in 16 and 17, PLLSRC (22), PLLQ in 24 to
// 27, of which 0 and 1 are wrong. 8 MHz / 4 × 168 / 2 = 168 MHz. RCC_CR is read and written, so the flags HSERDY (17)
// and PLLRDY (25) are written as they were read; PLLON is bit 24, CSSON bit 19.
TEST(Clock, StartFromTheCrystalWritesTheRegistersOfTheReferenceManual) {
    verifies<req::CO_CLOCK_001>();
    constexpr std::uint32_t pll_on = 0x83U | 1U << 16U | 1U << 17U | 1U << 24U;
    for (const ClockPlan& plan : {core_168_mhz, core_160_mhz}) {
        ClockAtItsAddresses bench;
        const std::uint32_t pll = 4U | plan.core_mhz << 6U | 1U << 22U | 7U << 24U;
        const auto [source, writes] = bench.start(plan);
        EXPECT_EQ(source, ClockSource::crystal);
        EXPECT_THAT(writes, ElementsAre(bench.power_on, bench.voltage, bench.crystal_on, bench.wait_states,
                                        Write{rcc_base + 0x04, pll}, Write{rcc_base, pll_on}, bench.dividers,
                                        bench.to_pll, Write{rcc_base, pll_on | 1U << 25U | 1U << 19U}));
        EXPECT_THAT(bench.model.faults(), IsEmpty());
    }
}

// 16 MHz / 8 × 168 / 2 = 168 MHz. HSEON is cleared again, and nothing watches the crystal.
TEST(Clock, StartWithoutACrystalSwitchesItOffAndWritesThePllForTheInternalOscillator) {
    verifies<req::CO_CLOCK_003>();
    ClockAtItsAddresses bench;
    bench.model.break_crystal();
    const auto [source, writes] = bench.start(core_168_mhz);
    EXPECT_EQ(source, ClockSource::internal);
    EXPECT_THAT(writes, ElementsAre(bench.power_on, bench.voltage, bench.crystal_on, bench.wait_states,
                                    Write{rcc_base, 0x83U}, Write{rcc_base + 0x04, 8U | 168U << 6U | 7U << 24U},
                                    Write{rcc_base, 0x83U | 1U << 24U}, bench.dividers, bench.to_pll));
}

// A driver with 100 polls reads a flag that never comes 100 times. RCC_CR is also read once for each of its changes.
TEST(Clock, FlagOfACrystalThatDoesNotStartIsReadAsOftenAsTheLimitSays) {
    verifies<req::CO_CLOCK_003>();
    ClockAtItsAddresses bench;
    bench.model.break_crystal();
    EXPECT_EQ(bench.start(core_168_mhz).first, ClockSource::internal);
    EXPECT_EQ(bench.log.reads_of(rcc_base), 100U + 3U + 1U);  // on, off, PLL on; the PLL locks at once
}

TEST(Clock, FlagOfAPllThatDoesNotLockIsReadAsOftenAsTheLimitSays) {
    verifies<req::CO_CLOCK_004>();
    ClockAtItsAddresses bench;
    bench.model.break_pll();
    EXPECT_EQ(bench.start(core_168_mhz).first, ClockSource::none);
    EXPECT_EQ(bench.log.reads_of(rcc_base), 1U + 2U + 100U);  // the crystal starts at once; on, PLL on
    EXPECT_EQ(bench.log.reads_of(rcc_base + 0x08), 0U);
}

TEST(Clock, SwitchThatTheHardwareDoesNotMakeIsReportedAfterItsLimitOfReads) {
    verifies<req::CO_CLOCK_004>();
    ClockAtItsAddresses bench;
    bench.model.break_switch();
    EXPECT_EQ(bench.start(core_168_mhz).first, ClockSource::none);
    EXPECT_EQ(bench.log.reads_of(rcc_base + 0x08), 100U);
    EXPECT_FALSE(bench.model.is_crystal_watched());
}

// RCC_CSR: RMVF (24) clears the flags that show the cause of the reset. The other bits are written as they were read:
// 0E000000h after a power-on.
TEST(Clock, ResetCauseIsForgottenByRmvf) {
    verifies<req::CO_D_SELF_001>();
    ClockAtItsAddresses bench;
    EXPECT_FALSE(bench.clock.take_watchdog_reset());
    EXPECT_THAT(bench.log.take_writes(), ElementsAre(Write{rcc_base + 0x74, 0x0E000000U | 1U << 24U}));
}

// ADC_CCR: ADCPRE = 1 (divides by 4, bits 16 and 17), TSVREFE (23). ADC_SMPR1: 7 (480 cycles) for the channels 10 to
// 18, ADC_SMPR2: 7 for 0 to 9. ADC_SQR1: L = 0, one conversion. ADC_CR2: ADON (0), SWSTART (30), which has an effect
// only after ADON (RM0090 13.13.3). ADC_SQR3: the channel, before SWSTART.
TEST(AnalogInputs, StartSetsTheConverterUpAndReadsEachChannelOnce) {
    verifies<req::CO_IMAGE_002>();
    AdcModel adc;
    adc.codes[0] = 4095;
    adc.codes[3] = 1365;
    adc.codes[16] = 943;
    AccessLog log;
    AnalogInputs inputs{registers_at<AdcRegisters>(adc1_base)};
    inputs.start(1U << 0U | 1U << 3U | 1U << 16U);
    const Write start{adc1_base + 0x08, 1U << 0U | 1U << 30U};
    const auto channel = [](std::uint32_t number) { return Write{adc1_base + 0x34, number}; };
    EXPECT_THAT(in_any_order(log.take_writes(), 0, 5),
                ElementsAre(Write{adc1_base + 0x08, 1U}, Write{adc1_base + 0x0C, 0777777777U},
                            Write{adc1_base + 0x10, 07777777777U}, Write{adc1_base + 0x2C, 0U},
                            Write{adc1_base + 0x304, 1U << 16U | 1U << 23U}, channel(3), start, channel(16), start,
                            channel(0), start, channel(3), start));
    EXPECT_THAT(adc.take_conversions(), ElementsAre(3U, 16U, 0U, 3U));  // the last one has not been read yet
    EXPECT_EQ(inputs.share(0), 1.0F);
    EXPECT_FLOAT_EQ(inputs.share(3), 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(inputs.share(16), 943.0F / 4095.0F);
    EXPECT_NEAR(inputs.chip_temperature(), 25.0F, 0.1F);  // 943 / 4095 × 3.3 V = 0.76 V
    EXPECT_THAT(adc.faults(), IsEmpty());
}

TEST(AnalogInputs, ChannelsAreConvertedInAscendingOrderAgainAndAgain) {
    verifies<req::CO_IMAGE_002>();
    AdcModel adc;
    AnalogInputs inputs{registers_at<AdcRegisters>(adc1_base)};
    inputs.start(1U << 4U | 1U << 5U | 1U << 16U);
    inputs.advance();
    EXPECT_THAT(adc.take_conversions(), ElementsAre(4U, 5U, 16U, 4U, 5U));
}

// The search for the next channel passes all other channels and comes back to the only one.
TEST(AnalogInputs, TheOnlyChannelIsConvertedAgainAndAgain) {
    verifies<req::CO_IMAGE_002>();
    for (const std::uint32_t channel : {0U, 7U, 16U}) {
        AdcModel adc;
        AnalogInputs inputs{registers_at<AdcRegisters>(adc1_base)};
        inputs.start(1U << channel);
        inputs.advance();
        EXPECT_THAT(adc.take_conversions(), ElementsAre(channel, channel, channel));
    }
}

TEST(AnalogInputs, StartEndsAlsoWithAConverterThatDoesNotAnswerAndWithoutAChannel) {
    verifies<req::CO_IMAGE_002>();
    AdcModel adc;
    adc.codes[3] = 4095;
    adc.answer(false);
    AnalogInputs inputs{registers_at<AdcRegisters>(adc1_base)};
    inputs.start(1U << 3U);
    EXPECT_THAT(adc.take_conversions(), ElementsAre(3U));
    EXPECT_EQ(inputs.share(3), 0.0F);
    AnalogInputs none{registers_at<AdcRegisters>(adc1_base)};
    none.start(0);
    EXPECT_EQ(none.share(3), 0.0F);
}

// TIM3_CCMR1: OC1M = 110 (PWM mode 1, bits 4 to 6), OC1PE (3), and the same from bit 8 on for channel 2. It is written
// while the channels are off, as its CC1S demands (RM0090 18.4.7). TIM3_CCER: CC1E (0), CC2E (4). 84 MHz / 1 kHz =
// 84,000 counts are 2 × 42,000. TIM3_EGR: UG (0) loads the preloaded values (RM0090 18.3.9), so it is the last write
// before TIM3_CR1: CEN (0), ARPE (7).
TEST(PulseOutputs, StartWritesTheRegistersOfTheReferenceManual) {
    verifies<req::CO_IMAGE_003>();
    PlainModel<TimerRegisters> timer;
    Window at_timer{tim3_base, timer.registers()};
    AccessLog log;
    PulseOutputs outputs{registers_at<TimerRegisters>(tim3_base), 84};
    outputs.start();
    constexpr std::uint32_t mode = 6U << 4U | 1U << 3U;
    EXPECT_THAT(
        in_any_order(log.take_writes(), 1, 6),
        ElementsAre(Write{tim3_base + 0x18, mode | mode << 8U}, Write{tim3_base + 0x20, 1U << 0U | 1U << 4U},
                    Write{tim3_base + 0x28, 1U}, Write{tim3_base + 0x2C, 41999U}, Write{tim3_base + 0x34, 0U},
                    Write{tim3_base + 0x38, 0U}, Write{tim3_base + 0x14, 1U}, Write{tim3_base, 1U << 0U | 1U << 7U}));
}

// 80 MHz. 1 Hz, the least frequency: 80,000,000 counts are 1221 × 65,520.07; 65,535 is the greatest period. 1 MHz, the
// greatest: 80 counts. 80 MHz / 1221 Hz = 65,520.06 counts need no prescaler.
TEST(PulseOutputs, PeriodHasTheSmallestPrescalerWithWhichItFitsInto16Bits) {
    verifies<req::CO_IMAGE_003>();
    struct Row {
        float hertz;
        std::uint32_t prescaler, reload;
    };
    PlainModel<TimerRegisters> timer;
    PulseOutputs outputs{timer.registers(), 80};
    for (const Row& row :
         {Row{1.0F, 1220, 65519}, {0.5F, 1220, 65519}, {1e6F, 0, 79}, {2e6F, 0, 79}, {1221.0F, 0, 65519}}) {
        outputs.set_frequency(row.hertz);
        EXPECT_EQ(timer.at(0x28), row.prescaler) << row.hertz;
        EXPECT_EQ(timer.at(0x2C), row.reload) << row.hertz;
    }
}

// TIM2_PSC divides by 84, TIM2_ARR counts all 32 bits. TIM2_EGR: UG (0) makes both effective. TIM2_CR1: CEN (0), when
// everything else is set.
TEST(TimeBase, StartWritesTheRegistersOfTheReferenceManual) {
    verifies<req::CO_CLOCK_002>();
    PlainModel<TimerRegisters> timer;
    Window at_timer{tim2_base, timer.registers()};
    AccessLog log;
    TimeBase time{registers_at<TimerRegisters>(tim2_base), 84};
    time.start();
    EXPECT_THAT(in_any_order(in_any_order(log.take_writes(), 0, 2), 2, 4),
                ElementsAre(Write{tim2_base + 0x28, 83U}, Write{tim2_base + 0x2C, 0xFFFFFFFFU},
                            Write{tim2_base + 0x14, 1U}, Write{tim2_base + 0x24, 0U}, Write{tim2_base, 1U}));
}

// IWDG_KR: CCCCh starts, 5555h permits IWDG_PR and IWDG_RLR, AAAAh refreshes and protects them again. 32 kHz / 32 =
// 1 kHz (PR = 3); 1000 counts are RLR = 999. A refresh before IWDG_SR is 0 would load the old period (RM0090 21.3.1).
TEST(Watchdog, StartWritesTheKeysAndThePeriodOfTheReferenceManual) {
    verifies<req::CO_WATCHDOG_001, req::CO_WATCHDOG_003>();
    WatchdogModel model;
    Window at_watchdog{iwdg_base, model.registers()};
    AccessLog log;
    Watchdog watchdog{registers_at<WatchdogRegisters>(iwdg_base), 100};
    EXPECT_TRUE(watchdog.start());
    EXPECT_THAT(in_any_order(log.take_writes(), 2, 4),
                ElementsAre(Write{iwdg_base, 0xCCCCU}, Write{iwdg_base, 0x5555U}, Write{iwdg_base + 0x04, 3U},
                            Write{iwdg_base + 0x08, 999U}, Write{iwdg_base, 0xAAAAU}));
    EXPECT_THAT(model.faults(), IsEmpty());
    model.stay_updating(true);
    const std::size_t before = log.reads_of(iwdg_base + 0x0C);
    EXPECT_FALSE(watchdog.start());
    EXPECT_EQ(log.reads_of(iwdg_base + 0x0C) - before, 100U);
}

// GPIOB_AFRH: four bits for each of the pins 8 to 15. GPIOB_MODER: two bits for each pin, 2 for an alternate function.
// A pin has its function before it becomes an alternate output, so that no other function drives it in between.
TEST(Port, FunctionOfAPinIsSetBeforeItsModeAndLeavesOtherPinsAlone) {
    verifies<req::CO_IMAGE_003>();
    PortModel model{gpiob_base};
    Port port{registers_at<GpioRegisters>(gpiob_base)};
    AccessLog log;
    port.configure(8, PinMode::alternate, 5);
    port.configure(9, PinMode::alternate, 9);
    port.configure(8, PinMode::output);
    EXPECT_THAT(log.take_writes(),
                ElementsAre(Write{gpiob_base + 0x24, 5U}, Write{gpiob_base, 2U << 16U},
                            Write{gpiob_base + 0x24, 9U << 4U | 5U}, Write{gpiob_base, 2U << 18U | 2U << 16U},
                            Write{gpiob_base + 0x24, 9U << 4U}, Write{gpiob_base, 2U << 18U | 1U << 16U}));
    port.pull_up(0);
    port.pull_up(15);
    EXPECT_THAT(log.take_writes(), ElementsAre(Write{gpiob_base + 0x0C, 1U}, Write{gpiob_base + 0x0C, 1U << 30U | 1U}));
    port.set(0, true);
    port.set(15, true);
    port.set(0, false);
    port.set(15, false);
    EXPECT_THAT(log.take_writes(),
                ElementsAre(Write{gpiob_base + 0x18, 1U}, Write{gpiob_base + 0x18, 1U << 15U},
                            Write{gpiob_base + 0x18, 1U << 16U}, Write{gpiob_base + 0x18, 1U << 31U}));
}

// CAN_IER: FMPIE0 (1) and FMPIE1 (4). NVIC_ISER0: CAN1_RX0 is interrupt 20, CAN1_RX1 is 21.
TEST(Chip, StartRunsTheTimeBaseAndTheReceiveInterruptsAndTakesTheResetCause) {
    verifies<req::CO_IMAGE_002, req::CO_D_SELF_001>();
    for (const bool by_watchdog : {false, true}) {
        ChipModel model;
        if (by_watchdog) {
            model.clock.reset_by_watchdog();
        }
        Chip chip{core_168_mhz};
        AccessLog log;
        chip.start();
        EXPECT_EQ(chip.was_reset_by_watchdog, by_watchdog);
        const Writes writes = log.take_writes();
        EXPECT_THAT(writes, testing::Contains(Write{tim2_base + 0x28, 83U}));  // 84 MHz / 84 = 1 MHz
        EXPECT_THAT(writes, testing::Contains(Write{tim2_base, 1U}));
        EXPECT_THAT(writes, testing::Contains(Write{can1_base + 0x14, 1U << 1U | 1U << 4U}));
        EXPECT_THAT(writes, testing::Contains(Write{nvic_base, 1U << 20U | 1U << 21U}));
        EXPECT_THAT(model.port_b.faults(), IsEmpty());
        EXPECT_THAT(model.at_tim2.faults(), IsEmpty());
        EXPECT_THAT(model.at_can.faults(), IsEmpty());
    }
}

TEST(Register, ReplaceWritesOnlyTheBitsOfItsMask) {
    shows_rule("a change of some bits of a register leaves its other bits alone");
    PlainModel<Register> model;
    model.at(0) = 0xA5A5A5A5U;
    model.registers().replace(0x0000FF00U, 0xFFFF3CFFU);
    EXPECT_EQ(model.at(0), 0xA5A53CA5U);
}

// RM0090 3.4, Table 5: sector 2 lies at 08008000h, sector 3 at 0800C000h; each has 16 KiB.
TEST(MemoryMap, ParametersLieInTheSectors2And3) {
    shows_rule("the parameter journal erases the sectors that it writes, not the program");
    const auto sectors = parameter_sectors();
    ASSERT_EQ(sectors.size(), 2U);
    EXPECT_EQ(sectors[0].number, 2U);
    EXPECT_EQ(sectors[1].number, 3U);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&sectors[0].words[0]), 0x08008000U);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&sectors[1].words[0]), 0x0800C000U);
    EXPECT_EQ(sectors[0].words.size() * 4, 0x4000U);
    EXPECT_EQ(sectors[1].words.size() * 4, 0x4000U);
}

}  // namespace canproof::test
