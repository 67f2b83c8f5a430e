// SPDX-License-Identifier: Apache-2.0
// Connects the AX060805's sensor to the pins of a microcontroller. The manual describes no wiring of the sensor; this
// board with an analog accelerometer is our own (src/target/stm32f405/README.md).
#pragma once

#include "devices/ax060805/firmware/ax060805.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/chip.hpp"

namespace canproof::ax060805 {

class Wiring {
  public:
    using Inputs = ax060805::Inputs;
    using Outputs = ax060805::Outputs;

    explicit Wiring(stm32f405::Chip& chip) : chip_{chip} {}

    void start() {
        for (const std::uint32_t pin : {0U, 1U, 2U, 3U, 4U}) {
            chip_.port_a.configure(pin, stm32f405::PinMode::analog);
        }
        chip_.port_b.configure(5, stm32f405::PinMode::output);
        chip_.analog_in.start(0x1FU | stm32f405::bit(stm32f405::AnalogInputs::temperature_channel));
    }

    static_assert(implements<req::CO_IMAGE_002>);
    void read(Inputs& inputs) {
        chip_.analog_in.advance();
        inputs.acceleration_x = acceleration(0);
        inputs.acceleration_y = acceleration(1);
        inputs.acceleration_z = acceleration(2);
        inputs.accelerometer_fault = !chip_.port_b.is_high(0);  // high: self-test of the sensor passed
        inputs.sensor_temperature = (chip_.analog_in.share(3) * 330.0F) - 50.0F;  // 10 mV per degree, 0.5 V at 0 degC
        inputs.supply_voltage = chip_.analog_in.share(4) * 72.6F;                 // a divider by 22
        inputs.processor_temperature = chip_.analog_in.chip_temperature();
    }

    /// Drives the slope pin of the transceiver: low selects the fast slew rate.
    static_assert(implements<req::CO_IMAGE_003>);
    void drive(const Outputs& outputs) { chip_.port_b.set(5, !outputs.slew_rate_fast); }

  private:
    /// Returns an acceleration, -3 to 3 g. The sensor gives 1.65 V at 0 g, and 0.55 V more per g.
    float acceleration(std::size_t channel) const { return (chip_.analog_in.share(channel) - 0.5F) * 6.0F; }

    stm32f405::Chip& chip_;
};

}  // namespace canproof::ax060805
