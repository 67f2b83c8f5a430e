// SPDX-License-Identifier: Apache-2.0
// The wiring of each device on models of the chip's peripherals: the pin and channel of each input and output are those
// of the board (src/target/stm32f405/README.md). Outputs of the DAC are on PA4 and PA5. By alternate function 2,
// channels 1 and 2 of TIM3 are on PA6 and PA7, and channel 1 of TIM4 is on PB6 (data sheet, Table 9).
#include <gmock/gmock.h>

#include "devices/ax060805/target/wiring.hpp"
#include "devices/ax130751/target/wiring.hpp"
#include "devices/ax188001/target/wiring.hpp"
#include "devices/cbx-ao412/target/wiring.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Mode = PortModel::Mode;
using stm32f405::SelfTest;
using testing::FloatNear;

constexpr std::size_t dac_1 = 0x08, dac_2 = 0x14, reload = 0x2C, compare_1 = 0x34, compare_2 = 0x38;

/// A device's wiring on the models, started. Channel n of the converter has the code 200 * (n + 1).
template <typename Wiring>
struct Board {
    ChipModel model;
    stm32f405::Chip chip;
    Wiring wiring{chip};

    explicit Board(const stm32f405::ClockPlan& plan = stm32f405::core_160_mhz) : chip{plan} {
        for (std::uint32_t channel = 0; channel < model.adc.codes.size(); ++channel) {
            model.adc.codes[channel] = 200 * (channel + 1);
        }
        chip.start();
        wiring.start();
    }
    typename Wiring::Inputs inputs() {
        typename Wiring::Inputs inputs{};
        wiring.read(inputs);
        return inputs;
    }
};

/// Returns the share of the reference voltage that the converter gives for a channel.
float share(std::uint32_t channel) {
    return static_cast<float>(200 * (channel + 1)) / 4095.0F;
}

/// The chip's sensor of temperature, channel 16: 0.76 V at 25 °C and 2.5 mV per degree, at a reference of 3.3 V.
float chip_temperature() {
    return (share(16) * 3.3F - 0.76F) / 0.0025F + 25.0F;
}

void expect_mode(const PortModel& port, std::initializer_list<std::uint32_t> pins, Mode mode) {
    for (const std::uint32_t pin : pins) {
        EXPECT_EQ(port.mode(pin), mode) << pin;
    }
}

}  // namespace

// RM0090 7.3.10, 7.3.13, 7.3.14: ports A to C; TIM2 to TIM5, CAN1 (bit 25), DAC (29), PWR (28); ADC1 (8).
TEST(Chip, ClocksAndCanPinsOfEachBoardAreOn) {
    verifies<req::CO_IMAGE_002, req::CO_IMAGE_003>();
    Board<ax188001::Wiring> board;
    EXPECT_EQ(board.chip.source, stm32f405::ClockSource::crystal);
    EXPECT_EQ(board.model.clock.enabled(0x30) & 0x7U, 0x7U);
    EXPECT_EQ(board.model.clock.enabled(0x40) & 0x3200000FU, 0x3200000FU);
    EXPECT_EQ(board.model.clock.enabled(0x44) & 0x100U, 0x100U);
    EXPECT_EQ(board.model.nvic.at(0), 3U << 20U);  // interrupts 20 and 21: the FIFOs of CAN1
    expect_mode(board.model.port_b, {8, 9}, Mode::alternate);
    EXPECT_EQ(board.model.port_b.function(8), 9U);
    EXPECT_EQ(board.model.port_b.function(9), 9U);
    EXPECT_TRUE(board.model.port_b.is_pulled_up(8));
}

// CAN-CBX-AO412: switches High PC0-3, Low PC4-7, Baud PC8-11, closed to ground.
TEST(CbxAo412Wiring, SwitchesAreReadFromTheirPins) {
    verifies<req::CO_IMAGE_002>();
    Board<cbx_ao412::Wiring> board;
    for (std::uint32_t pin = 0; pin < 12; ++pin) {
        EXPECT_EQ(board.model.port_c.mode(pin), Mode::input);
        EXPECT_TRUE(board.model.port_c.is_pulled_up(pin));
    }
    board.model.port_c.set_levels(~0x9A3U & 0xFFFFU);
    const cbx_ao412::Inputs inputs = board.inputs();
    EXPECT_EQ(inputs.switch_high, 0x3);
    EXPECT_EQ(inputs.switch_low, 0xA);
    EXPECT_EQ(inputs.switch_baud, 0x9);
}

// The amplifiers of the board convert 0 to 100 % to -10.24 to 10.24 V: 0 V is 50 %, and 5.12 V is 75 %. The DAC has
// 4095 steps, the pulses 80 MHz / 20 kHz = 4000.
TEST(CbxAo412Wiring, EachOutputDrivesItsOwnPin) {
    verifies<req::CO_IMAGE_003>();
    Board<cbx_ao412::Wiring> board;
    expect_mode(board.model.port_a, {4, 5}, Mode::analog);
    expect_mode(board.model.port_a, {6, 7}, Mode::alternate);
    EXPECT_EQ(board.model.port_a.function(6), 2U);
    EXPECT_EQ(board.model.port_a.function(7), 2U);
    EXPECT_EQ(board.model.tim3.at(reload), 3999U);
    const std::array<std::uint32_t, 4> rest{2048, 2048, 2000, 2000};
    const std::array<std::uint32_t, 4> raised{3071, 3071, 3000, 3000};
    for (std::size_t output = 0; output < 4; ++output) {
        cbx_ao412::Outputs outputs{};
        outputs.aout[output] = 5.12F;
        board.wiring.drive(outputs);
        const std::array<std::uint32_t, 4> driven{board.model.dac.at(dac_1), board.model.dac.at(dac_2),
                                                  board.model.tim3.at(compare_1), board.model.tim3.at(compare_2)};
        for (std::size_t pin = 0; pin < 4; ++pin) {
            EXPECT_EQ(driven[pin], pin == output ? raised[pin] : rest[pin]) << output << ' ' << pin;
        }
    }
}

TEST(CbxAo412Wiring, EachLedDrivesItsOwnPin) {
    verifies<req::CO_IMAGE_003>();
    Board<cbx_ao412::Wiring> board;
    expect_mode(board.model.port_b, {12, 13, 14, 15}, Mode::output);
    EXPECT_EQ(board.model.port_b.driven(), 0U);
    cbx_ao412::Outputs outputs{};
    const std::array<bool*, 4> leds{&outputs.led_e, &outputs.led_s, &outputs.led_m, &outputs.led_p};
    for (std::uint32_t led = 0; led < 4; ++led) {
        *leds[led] = true;
        board.wiring.drive(outputs);
        EXPECT_EQ(board.model.port_b.driven(), 1U << (12 + led));
        *leds[led] = false;
    }
}

TEST(CbxAo412Wiring, FailedSelfTestsAreReportedAsSoftwareOrHardware) {
    verifies<req::CO_SELF_016>();
    Board<cbx_ao412::Wiring> board;
    EXPECT_FALSE(board.inputs().internal_fault);
    EXPECT_FALSE(board.inputs().hardware_fault);
    board.chip.failed_test = SelfTest::flow;
    EXPECT_TRUE(board.inputs().internal_fault);
    EXPECT_FALSE(board.inputs().hardware_fault);
    board.chip.failed_test = SelfTest::ram;
    board.chip.was_reset_by_watchdog = true;
    EXPECT_FALSE(board.inputs().internal_fault);
    EXPECT_TRUE(board.inputs().hardware_fault);
    board.chip.failed_test = SelfTest::none;
    EXPECT_TRUE(board.inputs().internal_fault);
    EXPECT_FALSE(board.inputs().hardware_fault);
    board.chip.source = stm32f405::ClockSource::internal;
    EXPECT_TRUE(board.inputs().hardware_fault);
}

// AX188001: thermocouples PA0, PA1 with a gain of 33 around 1.65 V: -50 to 50 mV. Open circuit PB0, PB1 (low). Cold
// junction PA2 with 10 mV per degree, 0.5 V at 0 °C: -50 to 280 °C. Supply PA3 behind a divider by 40: 0 to 132 V.
TEST(Ax188001Wiring, EachInputIsReadFromItsOwnPin) {
    verifies<req::CO_IMAGE_002>();
    Board<ax188001::Wiring> board;
    expect_mode(board.model.port_a, {0, 1, 2, 3}, Mode::analog);
    expect_mode(board.model.port_b, {0, 1}, Mode::input);
    const ax188001::Inputs inputs = board.inputs();
    EXPECT_THAT(inputs.tc_microvolts[0], FloatNear((share(0) - 0.5F) * 100000.0F, 1.0F));
    EXPECT_THAT(inputs.tc_microvolts[1], FloatNear((share(1) - 0.5F) * 100000.0F, 1.0F));
    EXPECT_THAT(inputs.cold_junction, FloatNear(share(2) * 330.0F - 50.0F, 0.01F));
    EXPECT_THAT(inputs.supply, FloatNear(share(3) * 132.0F, 0.01F));
    EXPECT_THAT(inputs.cpu_temperature, FloatNear(chip_temperature(), 0.1F));
    for (std::uint32_t channel = 0; channel < 2; ++channel) {
        board.model.port_b.set_levels(0xFFFFU & ~(1U << channel));
        EXPECT_TRUE(board.inputs().tc_open[channel]);
        EXPECT_FALSE(board.inputs().tc_open[1 - channel]);
    }
}

// AX060805: accelerometer PA0-2, 0.55 V per g around 1.65 V: -3 to 3 g. Its self-test is PB0 (low: failed), its
// temperature PA3 (as on the AX188001). The supply is on PA4 behind a divider by 22: 0 to 72.6 V.
TEST(Ax060805Wiring, EachInputIsReadFromItsOwnPin) {
    verifies<req::CO_IMAGE_002>();
    Board<ax060805::Wiring> board;
    expect_mode(board.model.port_a, {0, 1, 2, 3, 4}, Mode::analog);
    EXPECT_EQ(board.model.port_b.mode(0), Mode::input);
    const ax060805::Inputs inputs = board.inputs();
    EXPECT_THAT(inputs.acceleration_x, FloatNear((share(0) - 0.5F) * 6.0F, 1e-4F));
    EXPECT_THAT(inputs.acceleration_y, FloatNear((share(1) - 0.5F) * 6.0F, 1e-4F));
    EXPECT_THAT(inputs.acceleration_z, FloatNear((share(2) - 0.5F) * 6.0F, 1e-4F));
    EXPECT_THAT(inputs.sensor_temperature, FloatNear(share(3) * 330.0F - 50.0F, 0.01F));
    EXPECT_THAT(inputs.supply_voltage, FloatNear(share(4) * 72.6F, 0.01F));
    EXPECT_THAT(inputs.processor_temperature, FloatNear(chip_temperature(), 0.1F));
    EXPECT_FALSE(inputs.accelerometer_fault);
    board.model.port_b.set_levels(0xFFFE);
    EXPECT_TRUE(board.inputs().accelerometer_fault);
}

// AX060805: the slope of the transceiver is PB5; low selects the fast slew rate.
TEST(Ax060805Wiring, SlewRateDrivesTheSlopePin) {
    verifies<req::CO_IMAGE_003>();
    Board<ax060805::Wiring> board;
    EXPECT_EQ(board.model.port_b.mode(5), Mode::output);
    ax060805::Outputs outputs{};
    outputs.slew_rate_fast = false;
    board.wiring.drive(outputs);
    EXPECT_EQ(board.model.port_b.driven(), 1U << 5U);
    outputs.slew_rate_fast = true;
    board.wiring.drive(outputs);
    EXPECT_EQ(board.model.port_b.driven(), 0U);
}

// AX130751: supply PA0 behind a divider by 20 (0 to 66 V), voltages at the outputs PA1, PA2 behind a divider by 8 (0 to
// 26.4 V). The load in ohms is this voltage divided by the current of the stage.
TEST(Ax130751Wiring, EachInputIsReadFromItsOwnPin) {
    verifies<req::CO_IMAGE_002>();
    Board<ax130751::Wiring> board{stm32f405::core_168_mhz};
    expect_mode(board.model.port_a, {0, 1, 2}, Mode::analog);
    ax130751::Wiring::Outputs outputs{};
    outputs.out_current[0] = 4.0F;
    outputs.out_current[1] = 20.0F;
    board.wiring.drive(outputs);
    const ax130751::Wiring::Inputs inputs = board.inputs();
    EXPECT_THAT(inputs.supply, FloatNear(share(0) * 66.0F, 0.01F));
    EXPECT_THAT(inputs.load[0], FloatNear(share(1) * 26.4F / 0.004F, 0.1F));
    EXPECT_THAT(inputs.load[1], FloatNear(share(2) * 26.4F / 0.020F, 0.1F));
    EXPECT_THAT(inputs.cpu_temperature, FloatNear(chip_temperature(), 0.1F));
}

// AX130751: DAC PA4, PA5, selected stage PB0, PB1 (high: 0 to 24 mA, low: -12 to 12 V), stage on PB2, PB3. 12 mA is
// 50 % of the DAC's range, 2047.5 steps, as is 0 V; 6 V is 75 %.
TEST(Ax130751Wiring, EachOutputDrivesItsDacStageAndState) {
    verifies<req::CO_IMAGE_003>();
    Board<ax130751::Wiring> board{stm32f405::core_168_mhz};
    expect_mode(board.model.port_a, {4, 5}, Mode::analog);
    expect_mode(board.model.port_b, {0, 1, 2, 3, 14}, Mode::output);
    EXPECT_EQ(board.model.port_b.driven(), 0U);
    for (std::uint32_t output = 0; output < 2; ++output) {
        const std::size_t own = output == 0 ? dac_1 : dac_2;
        const std::size_t other = output == 0 ? dac_2 : dac_1;
        ax130751::Wiring::Outputs outputs{};
        outputs.out_voltage[output] = 6.0F;
        board.wiring.drive(outputs);
        EXPECT_EQ(board.model.dac.at(own), 3071U);
        EXPECT_EQ(board.model.dac.at(other), 2048U);
        EXPECT_EQ(board.model.port_b.driven(), 4U << output);
        outputs = {};
        outputs.out_level[output] = -6.0F;  // of an output with pulses, or of a digital output that is off
        board.wiring.drive(outputs);
        EXPECT_EQ(board.model.dac.at(own), 1024U);  // 25 %
        EXPECT_EQ(board.model.dac.at(other), 2048U);
        EXPECT_EQ(board.model.port_b.driven(), 0U);
        outputs = {};
        outputs.out_current[output] = 6.0F;
        board.wiring.drive(outputs);
        EXPECT_EQ(board.model.dac.at(own), 1024U);  // 25 %
        EXPECT_EQ(board.model.dac.at(other), 2048U);
        EXPECT_EQ(board.model.port_b.driven(), (1U << output) | (4U << output));
        outputs = {};
        outputs.out_on[output] = true;
        board.wiring.drive(outputs);
        EXPECT_EQ(board.model.port_b.driven(), 4U << output);
    }
}

// AX130751: pulses PA6 (TIM3), PB6 (TIM4), relay PB14. The timers run at 84 MHz: 2 kHz are 42,000 counts, and 4 kHz are
// 21,000.
TEST(Ax130751Wiring, PulsesAndRelayDriveTheirOwnPins) {
    verifies<req::CO_IMAGE_003>();
    Board<ax130751::Wiring> board{stm32f405::core_168_mhz};
    EXPECT_EQ(board.model.port_a.mode(6), Mode::alternate);
    EXPECT_EQ(board.model.port_a.function(6), 2U);
    EXPECT_EQ(board.model.port_b.mode(6), Mode::alternate);
    EXPECT_EQ(board.model.port_b.function(6), 2U);
    ax130751::Wiring::Outputs outputs{};
    outputs.out_frequency[0] = 2000.0F;
    outputs.out_duty[0] = 50.0F;
    outputs.out_frequency[1] = 4000.0F;
    outputs.out_duty[1] = 10.0F;
    board.wiring.drive(outputs);
    EXPECT_EQ(board.model.tim3.at(reload), 41999U);
    EXPECT_EQ(board.model.tim3.at(compare_1), 21000U);
    EXPECT_EQ(board.model.tim4.at(reload), 20999U);
    EXPECT_EQ(board.model.tim4.at(compare_1), 2100U);
    EXPECT_EQ(board.model.port_b.driven(), 0U);
    outputs.relay_nc = true;
    board.wiring.drive(outputs);
    EXPECT_EQ(board.model.port_b.driven(), 1U << 14U);
}

}  // namespace canproof::test
