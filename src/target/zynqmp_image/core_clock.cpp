// SPDX-License-Identifier: Apache-2.0
#include "target/zynqmp_image/core_clock.hpp"

#include "target/zynqmp_image/memory_map.hpp"

namespace canproof::target {

namespace {

using zynqmp::Register;

constexpr std::uint64_t million = 1000000U;
constexpr std::uint32_t timer_interrupt = 27U;  // private interrupt of the virtual timer (UG1085, Table 13-1)
constexpr std::uint32_t timer_on = 1U;          // CNTV_CTL.ENABLE

// Registers of the GIC-400 (Arm DDI 0471, 3.2 and 3.3).
struct Distributor {
    Register control;  ///< 000h GICD_CTLR
    stm32f405::Reserved<63U> reserved_004{};
    Register enable;  ///< 100h GICD_ISENABLER0
};
struct Interface {
    Register control;        ///< 0h GICC_CTLR
    Register priority_mask;  ///< 4h GICC_PMR
};

std::uint64_t count() {
    std::uint32_t low;
    std::uint32_t high;
    asm volatile("isb\n mrrc p15, 1, %0, %1, c14" : "=r"(low), "=r"(high)::"memory");  // CNTVCT
    return (std::uint64_t{high} << 32U) | low;
}

void set_control(std::uint32_t bits) {
    asm volatile("mcr p15, 0, %0, c14, c3, 1\n isb" ::"r"(bits) : "memory");  // CNTV_CTL
}

void set_compare(std::uint64_t ticks) {
    asm volatile("mcrr p15, 3, %0, %1, c14" ::"r"(static_cast<std::uint32_t>(ticks)),  // CNTV_CVAL
                 "r"(static_cast<std::uint32_t>(ticks >> 32U))
                 : "memory");
}

}  // namespace

void CoreClock::start() {
    auto& distributor = zynqmp::registers_at<Distributor>(zynqmp::gic_distributor_address);
    auto& interface = zynqmp::registers_at<Interface>(zynqmp::gic_interface_address);
    distributor.enable.write(zynqmp::bit(timer_interrupt));
    distributor.control.write(1U);
    interface.priority_mask.write(0xFFU);
    interface.control.write(1U);
    std::uint32_t frequency;
    asm volatile("mrc p15, 0, %0, c14, c0, 0" : "=r"(frequency));  // CNTFRQ
    ticks_a_second_ = frequency;
    begin_ = count();
}

Instant CoreClock::now() const {
    return Instant{((count() - begin_) * million) / ticks_a_second_};
}

void CoreClock::sleep(const Instant until) const {
    while (now() < until) {
        set_compare(begin_ + (((until.us * ticks_a_second_) + million - 1U) / million));
        set_control(timer_on);
        asm volatile("dsb\n wfi" ::: "memory");
        set_control(0U);
    }
}

}  // namespace canproof::target
