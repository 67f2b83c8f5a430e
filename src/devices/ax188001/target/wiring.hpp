// SPDX-License-Identifier: Apache-2.0
// Connects the AX188001's terminals to the pins of its STM32F405. The manual names the microcontroller and 16-bit
// converters but no pins; this board with the chip's own 12-bit converter is our own (src/target/stm32f405/README.md).
#pragma once

#include "devices/ax188001/firmware/ax188001.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/chip.hpp"

namespace canproof::ax188001 {

class Wiring {
  public:
    using Inputs = ax188001::Inputs;
    using Outputs = ax188001::Outputs;

    explicit Wiring(stm32f405::Chip& chip) : chip_{chip} {}

    void start() {
        for (const std::uint32_t pin : {0U, 1U, 2U, 3U}) {
            chip_.port_a.configure(pin, stm32f405::PinMode::analog);
        }
        chip_.analog_in.start(0xFU | stm32f405::bit(stm32f405::AnalogInputs::temperature_channel));
    }

    static_assert(implements<req::CO_IMAGE_002>);
    void read(Inputs& inputs) {
        chip_.analog_in.advance();
        inputs.tc_microvolts[0] = microvolts(0);
        inputs.tc_microvolts[1] = microvolts(1);
        inputs.tc_open[0] = !chip_.port_b.is_high(0);  // comparators pull the pin low on an open circuit
        inputs.tc_open[1] = !chip_.port_b.is_high(1);
        inputs.cold_junction = (chip_.analog_in.share(2) * 330.0F) - 50.0F;  // 10 mV per degree, 0.5 V at 0 °C
        inputs.supply = chip_.analog_in.share(3) * 132.0F;                   // a divider by 40
        inputs.cpu_temperature = chip_.analog_in.chip_temperature();
    }

    /// Does nothing, because gain and filter belong to converters that this board does not have.
    void drive(const Outputs&) {}

  private:
    /// Returns a thermocouple voltage in µV, -50,000 to 50,000. The amplifier has a gain of 33; its output is 1.65 V at
    /// 0 µV.
    float microvolts(std::size_t channel) const { return (chip_.analog_in.share(channel) - 0.5F) * 100000.0F; }

    stm32f405::Chip& chip_;
};

}  // namespace canproof::ax188001
