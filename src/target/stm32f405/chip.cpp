// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/chip.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/device_loop.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::uint32_t can_receive_pin = 8U;
constexpr std::uint32_t can_transmit_pin = 9U;
constexpr std::uint32_t can_function = 9U;

}  // namespace

static_assert(implements<req::CO_IMAGE_002> && implements<req::CO_IMAGE_003>);
void Chip::start() noexcept {
    source = clock.start(plan);
    ClockRegisters& clocks = registers_at<ClockRegisters>(rcc_address);
    clocks.enable_ahb[0U].set(ahb1_ports_a_to_c);
    clocks.enable_apb[0U].set(apb1_tim2_to_5 | apb1_can1 | apb1_dac);
    clocks.enable_apb[1U].set(apb2_adc1);
    was_reset_by_watchdog = clock.take_watchdog_reset();
    time.start();
    port_b.pull_up(can_receive_pin);  // without a transceiver the input reads as a recessive bus
    port_b.configure(can_receive_pin, PinMode::alternate, can_function);
    port_b.configure(can_transmit_pin, PinMode::alternate, can_function);
    can.interrupt_on_frames(true);
    registers_at<Register>(nvic_enable_address).write(can1_receive_interrupts);
}

}  // namespace canproof::stm32f405
