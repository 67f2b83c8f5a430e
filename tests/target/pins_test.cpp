// SPDX-License-Identifier: Apache-2.0
// Tests the pins, converters and pulse outputs of a board, with plain variables in place of the registers. The offsets
// of the registers are those of RM0090, chapters 8, 13, 14 and 18.
#include <gmock/gmock.h>

#include <cmath>

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/analog.hpp"
#include "target/stm32f405/gpio.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace stm32f405;

constexpr std::size_t adc_status = 0x00;
constexpr std::size_t adc_sequence_3 = 0x34;
constexpr std::size_t adc_data = 0x4C;
constexpr std::uint32_t end_of_conversion = 2;

}  // namespace

TEST(AnalogInputs, AnalogInputsKeepTheLastConversionOfEachChannel) {
    verifies<req::CO_IMAGE_002>();
    PlainModel<AdcRegisters> adc;
    adc.at(adc_status) = end_of_conversion;
    AnalogInputs inputs{adc.registers()};
    inputs.start((1U << 3U) | (1U << 5U));
    for (int turn = 0; turn < 2; ++turn) {
        adc.at(adc_data) = 100 * adc.at(adc_sequence_3);  // channel n, which is being converted, gives the value 100 *
                                                          // n
        inputs.advance();
    }
    EXPECT_FLOAT_EQ(inputs.share(3), 300.0F / 4095.0F);
    EXPECT_FLOAT_EQ(inputs.share(5), 500.0F / 4095.0F);
    EXPECT_EQ(inputs.share(4), 0.0F);
    adc.at(adc_status) = 0;  // clears the status: the present conversion has not ended
    adc.at(adc_data) = 4095;
    inputs.advance();
    EXPECT_FLOAT_EQ(inputs.share(3), 300.0F / 4095.0F);
    EXPECT_FLOAT_EQ(inputs.share(5), 500.0F / 4095.0F);
}

TEST(AnalogOutputs, AnalogOutputsSetAFractionOfFullScaleOnEachChannel) {
    verifies<req::CO_IMAGE_003>();
    PlainModel<DacRegisters> dac;
    AnalogOutputs outputs{dac.registers()};
    outputs.start();
    EXPECT_EQ(dac.at(0x00), 0x00010001U);  // both channels are on
    outputs.set(0, 0.5F);
    outputs.set(1, 1.0F);
    EXPECT_EQ(dac.at(0x08), 2048U);  // 0.5 * 4095 rounded
    EXPECT_EQ(dac.at(0x14), 4095U);
    outputs.set(0, -1.0F);
    outputs.set(1, 2.0F);
    EXPECT_EQ(dac.at(0x08), 0U);
    EXPECT_EQ(dac.at(0x14), 4095U);
    outputs.set(1, std::nanf(""));
    EXPECT_EQ(dac.at(0x14), 0U);
}

TEST(PulseOutputs, PulseOutputsSetFrequencyAndDutyCycleOfTheTimer) {
    verifies<req::CO_IMAGE_003>();
    PlainModel<TimerRegisters> timer;
    PulseOutputs outputs{timer.registers(), 84};
    outputs.start();
    outputs.set_frequency(1000.0F);
    EXPECT_EQ(timer.at(0x28),
              1U);  // 84 MHz / 1 kHz = 84,000 counts are above 65,535, so the timer counts every second clock
    EXPECT_EQ(timer.at(0x2C), 41999U);  // the period is 42,000 counts; the register contains 42,000 - 1
    outputs.set_duty(0, 0.5F);
    outputs.set_duty(1, 0.25F);
    EXPECT_EQ(timer.at(0x34), 21000U);
    EXPECT_EQ(timer.at(0x38), 10500U);
}

TEST(Port, PortPinsCanBeReadSetAndConfigured) {
    verifies<req::CO_IMAGE_002, req::CO_IMAGE_003>();
    PlainModel<GpioRegisters> gpio;
    Port port{gpio.registers()};
    gpio.at(0x10) = 0xA5;
    EXPECT_EQ(port.read(4, 4), 0xAU);
    EXPECT_TRUE(port.is_high(0));
    EXPECT_FALSE(port.is_high(1));
    port.set(3, true);
    EXPECT_EQ(gpio.at(0x18), 1U << 3U);
    port.set(3, false);
    EXPECT_EQ(gpio.at(0x18), 1U << 19U);  // the upper half of the register resets pins
    port.configure(9, PinMode::alternate, 9);
    EXPECT_EQ(gpio.at(0x00), 2U << 18U);
    EXPECT_EQ(gpio.at(0x24), 9U << 4U);
}

}  // namespace canproof::test
