// SPDX-License-Identifier: Apache-2.0
// Connects the AX130751's terminals to the pins of its STM32F405. The manual names the microcontroller but no pins;
// this board is our own (src/target/stm32f405/README.md).
#pragma once

#include "devices/ax130751/firmware/ax130751.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/chip.hpp"

namespace canproof::ax130751 {

class Wiring {
  public:
    using Inputs = generated::ax130751::Inputs;
    using Outputs = generated::ax130751::Outputs;

    explicit Wiring(stm32f405::Chip& chip) : chip_{chip} {}

    void start() {
        for (const std::uint32_t pin : {0U, 1U, 2U, 4U, 5U}) {
            chip_.port_a.configure(pin, stm32f405::PinMode::analog);
        }
        chip_.port_a.configure(6, stm32f405::PinMode::alternate, 2);  // TIM3, channel 1
        chip_.port_b.configure(6, stm32f405::PinMode::alternate, 2);  // TIM4, channel 1
        for (const std::uint32_t pin : {0U, 1U, 2U, 3U, 14U}) {
            chip_.port_b.configure(pin, stm32f405::PinMode::output);
        }
        chip_.analog_in.start(0x7U | stm32f405::bit(stm32f405::AnalogInputs::temperature_channel));
        chip_.analog_out.start();
        chip_.pulses_3.start();
        chip_.pulses_4.start();
        drive(Outputs{});
    }

    static_assert(implements<req::CO_IMAGE_002>);
    void read(Inputs& inputs) {
        chip_.analog_in.advance();
        inputs.supply = chip_.analog_in.share(0) * 66.0F;  // a divider by 20
        inputs.cpu_temperature = chip_.analog_in.chip_temperature();
        for (std::size_t i = 0; i < 2; ++i) {
            // The load is the voltage at the output, measured behind a divider by 8, divided by the current of the
            // stage.
            const float volts = chip_.analog_in.share(i + 1) * 26.4F;
            if (current_ma_[i] > 0.1F) {
                inputs.load[i] = (volts * 1000.0F) / current_ma_[i];
            }
        }
    }

    static_assert(implements<req::CO_IMAGE_003>);
    void drive(const Outputs& outputs) {
        for (std::uint32_t i = 0; i < 2; ++i) {
            const bool is_voltage = outputs.out_voltage[i] != 0.0F;
            const float volts = is_voltage ? outputs.out_voltage[i] : outputs.out_level[i];
            current_ma_[i] = outputs.out_current[i];
            const bool is_current = outputs.out_current[i] > 0.0F;
            chip_.port_b.set(i, is_current);  // selects the stage that the DAC controls: 0 to 24 mA, or -12 to 12 V
            chip_.analog_out.set(i, is_current ? (outputs.out_current[i] / 24.0F) : ((volts + 12.0F) / 24.0F));
            // Switches the stage on. When this pin is low, the pulses switch the stage: without pulses it is off, also
            // when the DAC has the level of a digital output that is off.
            chip_.port_b.set(2U + i, is_voltage || is_current || outputs.out_on[i]);
            stm32f405::PulseOutputs& pulses = (i == 0U) ? chip_.pulses_3 : chip_.pulses_4;
            pulses.set_frequency(outputs.out_frequency[i]);
            pulses.set_duty(0, outputs.out_duty[i] / 100.0F);
        }
        chip_.port_b.set(14, outputs.relay_nc);
    }

  private:
    stm32f405::Chip& chip_;
    std::array<float, 2> current_ma_{};
};

}  // namespace canproof::ax130751
