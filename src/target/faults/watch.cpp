// SPDX-License-Identifier: Apache-2.0
#include "target/faults/watch.hpp"

#include "target/faults/machine.hpp"
#include "target/stm32f405/memory_map.hpp"

extern "C" {
/// 1 while a block is watched; fault() in machine.cpp reads it.
std::uint32_t watch_is_on;
}

namespace canproof::faults {

namespace {

using stm32f405::registers_at;

/// Memory protection unit of ARMv7-M, without the type register.
struct ProtectionUnit {
    volatile std::uint32_t control;
    volatile std::uint32_t number;
    volatile std::uint32_t address;
    volatile std::uint32_t attributes;
};

ProtectionUnit& unit() {
    return registers_at<ProtectionUnit>(0xE000ED94U);
}

volatile std::uint32_t& system_register(std::uintptr_t address) {
    return registers_at<volatile std::uint32_t>(address);
}

constexpr std::uint32_t pends_sv = 1U << 28U;
constexpr std::uintptr_t fault_status = 0xE000ED28U;       // CFSR
constexpr std::uintptr_t hard_fault_status = 0xE000ED2CU;  // HFSR
constexpr std::uintptr_t fault_address = 0xE000ED34U;      // MMFAR
constexpr std::uint32_t fetch_violation = 1U;              // IACCVIOL
constexpr std::uint32_t data_violation = 2U;               // DACCVIOL
constexpr std::uint32_t on = 5U;  // the unit is enabled; addresses outside of its regions are accessible as before

/// Attributes of a region of 2^log2_bytes bytes.
constexpr std::uint32_t region(std::uint32_t log2_bytes, std::uint32_t access) {
    return access | ((log2_bytes - 1U) << 1U) | 1U;
}
constexpr std::uint32_t no_access = 1U << 28U;  // nor execution
constexpr std::uint32_t read_only = 6U << 24U;

struct Region {
    std::uint32_t address;
    std::uint32_t attributes;
};
/// The input (8 MiB), the record (4 MiB) and the code of the harness (256 KiB); see faults.ld.
constexpr Region of_harness[] = {{0x21000000U, region(23U, read_only)},
                                 {0x21800000U, region(22U, read_only)},
                                 {0x21C00000U, region(18U, read_only)}};

bool masks_interrupts() {
    std::uint32_t mask = 0;
    asm volatile("mrs %0, primask" : "=r"(mask));
    return mask != 0U;
}

void set_region(std::uint32_t number, const Region& one) {
    unit().number = number;
    unit().address = one.address;
    unit().attributes = one.attributes;
    asm volatile("dsb\n isb" ::: "memory");
}

std::uint32_t watched;

/// Numbers of the regions: the watched block and the block before it. An access that begins before a block and reaches
/// into it is an access to the block before.
constexpr std::uint32_t watch_regions[] = {0U, 4U};
constexpr std::uint32_t first_of_harness = 1U;
constexpr std::uint32_t unused_regions[] = {5U, 6U, 7U};

void stop_watching() {
    for (const std::uint32_t number : watch_regions) {
        set_region(number, Region{});
    }
}

}  // namespace

void protect_harness() {
    std::uint32_t number = first_of_harness;
    for (const Region& one : of_harness) {
        set_region(number++, one);
    }
    for (const std::uint32_t unused : unused_regions) {
        set_region(unused, Region{});
    }
    unit().control = on;
    asm volatile("dsb\n isb" ::: "memory");
}

void watch_block(std::uint32_t address) {
    watched = address & ~(block_bytes - 1U);
    watch_is_on = 1U;
    resume_watch();
}

void end_watch() {
    watch_is_on = 0U;
    stop_watching();
}

bool is_unused() {
    return watch_is_on != 0U;
}

void resume_watch() {
    if (watch_is_on != 0U) {
        std::uint32_t block = watched;
        for (const std::uint32_t number : watch_regions) {
            set_region(number, {block, region(5U, no_access)});
            block -= block_bytes;
        }
    }
}

/// The march of the RAM's self-test is the only code of the device that masks interrupts. PendSV, which waits until the
/// march permits interrupts again, continues the watch.
bool access_was_watched(const Interrupted& interrupted) {
    const std::uint32_t status = system_register(fault_status);
    const std::uint32_t at = (status & data_violation) != 0U ? system_register(fault_address) : interrupted.pc;
    if ((status & (fetch_violation | data_violation)) == 0U || at < watched - block_bytes ||
        at >= watched + block_bytes) {
        return false;
    }
    system_register(fault_status) = status;  // a 1 clears its bit
    system_register(hard_fault_status) = system_register(hard_fault_status);
    if (masks_interrupts()) {
        stop_watching();
        system_register(interrupt_control) = pends_sv;
    } else {
        end_watch();
    }
    return true;
}

}  // namespace canproof::faults
