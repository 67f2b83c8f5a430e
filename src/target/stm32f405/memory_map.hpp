// SPDX-License-Identifier: Apache-2.0
// Addresses of the peripherals of an STM32F405 (RM0090 2.3, Table 1; those of the core in ARMv7-M B3). Only images use
// this file; tests pass models to the drivers.
#pragma once

#include "target/stm32f405/analog.hpp"
#include "target/stm32f405/bxcan_registers.hpp"
#include "target/stm32f405/clock.hpp"
#include "target/stm32f405/gpio.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "target/stm32f405/selftest/clock_check.hpp"
#include "target/stm32f405/time_base.hpp"
#include "target/stm32f405/watchdog.hpp"

namespace canproof::stm32f405 {

constexpr std::uintptr_t tim2_address = 0x40000000U;
constexpr std::uintptr_t tim3_address = 0x40000400U;
constexpr std::uintptr_t tim4_address = 0x40000800U;
constexpr std::uintptr_t tim5_address = 0x40000C00U;
constexpr std::uintptr_t iwdg_address = 0x40003000U;
constexpr std::uintptr_t can1_address = 0x40006400U;
constexpr std::uintptr_t pwr_address = 0x40007000U;
constexpr std::uintptr_t dac_address = 0x40007400U;
constexpr std::uintptr_t adc1_address = 0x40012000U;
constexpr std::uintptr_t gpioa_address = 0x40020000U;
constexpr std::uintptr_t gpiob_address = 0x40020400U;
constexpr std::uintptr_t gpioc_address = 0x40020800U;
constexpr std::uintptr_t rcc_address = 0x40023800U;
constexpr std::uintptr_t flash_address = 0x40023C00U;
constexpr std::uintptr_t nvic_enable_address = 0xE000E100U;  // NVIC_ISER0

// Sectors of 16 KiB (RM0090 3.4, Table 5): 0 holds the vectors, 2 and 3 the parameters.
constexpr std::uintptr_t sector_2_address = 0x08008000U;
constexpr std::uintptr_t sector_3_address = 0x0800C000U;
constexpr std::size_t sector_words = 4096U;

/// Returns the registers at an address.
template <typename Registers>
inline Registers& registers_at(const std::uintptr_t address) noexcept {
    return *reinterpret_cast<Registers*>(address);
}

/// Returns the two sectors of the parameter journal.
inline std::array<FlashSector, ParameterJournal::sector_count> parameter_sectors() noexcept {
    return {FlashSector{2U, Slots<Register>{&registers_at<Register>(sector_2_address), sector_words}},
            FlashSector{3U, Slots<Register>{&registers_at<Register>(sector_3_address), sector_words}}};
}

// Clock enable bits of peripherals: RCC_AHB1ENR, RCC_APB1ENR, RCC_APB2ENR (RM0090 7.3.10, 7.3.13, 7.3.14).
constexpr std::uint32_t ahb1_ports_a_to_c = 0x7U;
constexpr std::uint32_t apb1_tim2_to_5 = 0xFU;
constexpr std::uint32_t apb1_can1 = bit(25U);
constexpr std::uint32_t apb1_dac = bit(29U);
constexpr std::uint32_t apb2_adc1 = bit(8U);
/// CAN1_RX0 and CAN1_RX1, interrupts 20 and 21 (RM0090 12.1.3, Table 62).
constexpr std::uint32_t can1_receive_interrupts = bit(20U) | bit(21U);

}  // namespace canproof::stm32f405
