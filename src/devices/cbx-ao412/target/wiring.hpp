// SPDX-License-Identifier: Apache-2.0
// Connects the CAN-CBX-AO412's terminals to the pins of an STM32F405. The manual names another microcontroller and no
// pins; this board is our own (src/target/stm32f405/README.md).
#pragma once

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/chip.hpp"

namespace canproof::cbx_ao412 {

class Wiring {
  public:
    using Inputs = cbx_ao412::Inputs;
    using Outputs = cbx_ao412::Outputs;

    explicit Wiring(stm32f405::Chip& chip) : chip_{chip} {}

    void start() {
        for (std::uint32_t pin = 0; pin < 12; ++pin) {
            chip_.port_c.pull_up(pin);  // three coding switches, which connect to ground when closed
        }
        for (const std::uint32_t pin : {12U, 13U, 14U, 15U}) {
            chip_.port_b.configure(pin, stm32f405::PinMode::output);
        }
        chip_.port_a.configure(4, stm32f405::PinMode::analog);  // DAC
        chip_.port_a.configure(5, stm32f405::PinMode::analog);
        chip_.port_a.configure(6, stm32f405::PinMode::alternate, 2);  // TIM3, channels 1 and 2
        chip_.port_a.configure(7, stm32f405::PinMode::alternate, 2);
        chip_.analog_out.start();
        chip_.pulses_3.start();
        chip_.pulses_3.set_frequency(20000.0F);  // 80 MHz / 20 kHz = 4000 steps, nearly 12 bits
        drive(Outputs{});
    }

    static_assert(implements<req::CO_IMAGE_002>);
    void read(Inputs& inputs) {
        inputs.switch_high = static_cast<std::uint8_t>(~chip_.port_c.read(0, 4) & 0xFU);
        inputs.switch_low = static_cast<std::uint8_t>(~chip_.port_c.read(4, 4) & 0xFU);
        inputs.switch_baud = static_cast<std::uint8_t>(~chip_.port_c.read(8, 4) & 0xFU);
        static_assert(implements<req::CO_SELF_016>);
        const bool has_crystal = chip_.source == stm32f405::ClockSource::crystal;
        const stm32f405::StartFaults faults =
            stm32f405::faults_at_start(chip_.failed_test, chip_.was_reset_by_watchdog, has_crystal);
        inputs.internal_fault = faults.software;
        inputs.hardware_fault = faults.hardware;
    }

    static_assert(implements<req::CO_IMAGE_003>);
    void drive(const Outputs& outputs) {
        chip_.analog_out.set(0, share(outputs.aout[0]));
        chip_.analog_out.set(1, share(outputs.aout[1]));
        chip_.pulses_3.set_duty(0, share(outputs.aout[2]));
        chip_.pulses_3.set_duty(1, share(outputs.aout[3]));
        chip_.port_b.set(12, outputs.led_e);
        chip_.port_b.set(13, outputs.led_s);
        chip_.port_b.set(14, outputs.led_m);
        chip_.port_b.set(15, outputs.led_p);
    }

  private:
    /// Returns the duty cycle or the share of the DAC's range (0…1) for an output voltage: an amplifier converts 0…3.3
    /// V to -10.24…10.24 V.
    static float share(float volts) { return (volts + 10.24F) / 20.48F; }

    stm32f405::Chip& chip_;
};

}  // namespace canproof::cbx_ao412
