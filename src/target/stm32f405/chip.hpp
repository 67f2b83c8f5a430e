// SPDX-License-Identifier: Apache-2.0
// The drivers of one STM32F405 on its real registers.
#pragma once

#include "target/stm32f405/analog.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "target/stm32f405/clock.hpp"
#include "target/stm32f405/gpio.hpp"
#include "target/stm32f405/memory_map.hpp"
#include "target/stm32f405/selftest/failure_record.hpp"

namespace canproof::stm32f405 {

/// The chip with all drivers. CAN1 uses PB8 (receive) and PB9 (transmit), alternate function 9 (data sheet, Table 9).
struct Chip {
    explicit Chip(const ClockPlan& clock_plan) noexcept : plan{clock_plan} {}

    ClockPlan plan;
    Clock clock{registers_at<ClockRegisters>(rcc_address), registers_at<PowerRegisters>(pwr_address),
                registers_at<FlashRegisters>(flash_address)};
    Flash flash{registers_at<FlashRegisters>(flash_address)};
    Watchdog watchdog{registers_at<WatchdogRegisters>(iwdg_address)};
    TimeBase time{registers_at<TimerRegisters>(tim2_address), plan.timer_mhz()};
    Bxcan can{registers_at<BxcanRegisters>(can1_address), plan.apb1_hz()};
    Port port_a{registers_at<GpioRegisters>(gpioa_address)};
    Port port_b{registers_at<GpioRegisters>(gpiob_address)};
    Port port_c{registers_at<GpioRegisters>(gpioc_address)};
    AnalogInputs analog_in{registers_at<AdcRegisters>(adc1_address)};
    AnalogOutputs analog_out{registers_at<DacRegisters>(dac_address)};
    PulseOutputs pulses_3{registers_at<TimerRegisters>(tim3_address), plan.timer_mhz()};
    PulseOutputs pulses_4{registers_at<TimerRegisters>(tim4_address), plan.timer_mhz()};
    ClockSource source{ClockSource::none};
    bool was_reset_by_watchdog{false};
    SelfTest failed_test{SelfTest::none};  ///< the self-test that failed before the last reset

    /// Starts the clocks, the time base, and the pins and interrupts of CAN; the Wiring of a device starts the rest.
    void start() noexcept;
};

}  // namespace canproof::stm32f405
