// SPDX-License-Identifier: Apache-2.0
#include "target/faults/watch.hpp"

#include "target/faults/machine.hpp"

extern "C" {
/// 1 while a block is watched; fault() in machine.cpp reads it.
std::uint32_t watch_is_on;
}

namespace canproof::faults {

namespace {

/// Memory protection unit of ARMv7-M, without the type register.
struct ProtectionUnit {
    volatile std::uint32_t control;
    volatile std::uint32_t number;
    volatile std::uint32_t address;
    volatile std::uint32_t attributes;
};

ProtectionUnit& unit() {
    constexpr std::uintptr_t place = 0xE000ED94U;
    return *reinterpret_cast<ProtectionUnit*>(place);
}

volatile std::uint32_t& system_register(std::uintptr_t address) {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

constexpr std::uintptr_t interrupt_control = 0xE000ED04U;
constexpr std::uint32_t pends_sv = 1U << 28U;
constexpr std::uintptr_t fault_status = 0xE000ED28U;       // CFSR
constexpr std::uintptr_t hard_fault_status = 0xE000ED2CU;  // HFSR
constexpr std::uint32_t access_violations = 3U;            // IACCVIOL, DACCVIOL
constexpr std::uint32_t on = 5U;  // the unit is enabled; addresses outside of its regions are accessible as before
/// The region is enabled, has 2^(4 + 1) bytes, and permits neither access nor execution.
constexpr std::uint32_t forbidden_block = (1U << 28U) | (4U << 1U) | 1U;

bool masks_interrupts() {
    std::uint32_t mask = 0;
    asm volatile("mrs %0, primask" : "=r"(mask));
    return mask != 0U;
}

void control(std::uint32_t value) {
    unit().control = value;
    asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

void watch_block(std::uint32_t address) {
    unit().number = 0U;
    unit().address = address & ~(block_bytes - 1U);
    unit().attributes = forbidden_block;
    watch_is_on = 1U;
    control(on);
}

void end_watch() {
    watch_is_on = 0U;
    control(0U);
}

bool is_unused() {
    return watch_is_on != 0U;
}

void resume_watch() {
    if (watch_is_on != 0U) {
        control(on);
    }
}

/// The march of the RAM's self-test is the only code of the device that masks interrupts. PendSV, which waits until the
/// march permits interrupts again, continues the watch.
bool access_was_watched() {
    if ((system_register(fault_status) & access_violations) == 0U) {
        return false;
    }
    system_register(fault_status) = system_register(fault_status);  // a 1 clears its bit
    system_register(hard_fault_status) = system_register(hard_fault_status);
    if (masks_interrupts()) {
        control(0U);
        system_register(interrupt_control) = pends_sv;
    } else {
        end_watch();
    }
    return true;
}

}  // namespace canproof::faults
