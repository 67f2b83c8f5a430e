// SPDX-License-Identifier: Apache-2.0
#include "target/faults/machine.hpp"

#include "target/faults/watch.hpp"
#include "target/semihost.hpp"
#include "target/stm32f405/memory_map.hpp"
#include "target/sys_tick.hpp"

extern "C" {
extern std::uint32_t stack_top[];
extern std::uint32_t harness_stack_top[];
std::uint32_t harness_stack_pointer;
void fault();
void image_main();
[[noreturn]] void begin_on_harness_stack();
[[noreturn]] void resume_after(std::uint32_t was_exception);
std::uint32_t take_exception(canproof::faults::Interrupted* interrupted, std::uint32_t return_kind,
                             std::uint32_t number);
}

namespace canproof::faults {

namespace {

using stm32f405::registers_at;

/// Watchdog of QEMU's mps2-an386 (CMSDK). At 0 it raises the interrupt that nothing can mask.
struct Watchdog {
    volatile std::uint32_t load;
    volatile std::uint32_t value;
    volatile std::uint32_t control;
    volatile std::uint32_t clear;
};

Watchdog& watchdog() {
    return registers_at<Watchdog>(0x40008000U);
}

/// Numbers of exceptions, and what take_exception() returns.
constexpr std::uint32_t hard_fault = 3U;
constexpr std::uint32_t pend_sv = 14U;
constexpr std::uint32_t ends_hanging = 0U;
constexpr std::uint32_t continues = 1U;
constexpr std::uint32_t ends_by_exception = 2U;

constexpr std::uint32_t counts = 5U;      // the timer is enabled and counts the processor clock
constexpr std::uint32_t interrupts = 7U;  // as `counts`; in addition, the timer raises an interrupt at 0
constexpr int sys_write0 = 0x04;
constexpr int sys_exit_extended = 0x20;

}  // namespace

/// Saves all registers that a function must preserve, s16 to s31 included, because a device with a fault may not
/// restore them. The device begins with zeros in its registers, so that a run does not depend on earlier runs.
[[gnu::naked]] void run_on_device_stack(void (*)()) {
    asm volatile(R"(
        push {r4-r11, lr}
        vpush {s16-s31}
        ldr r1, =harness_stack_pointer
        str sp, [r1]
        ldr r1, =stack_top
        mov sp, r1
        mov r1, #0
        .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
        vmov s\n, r1
        .endr
        .irp reg, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12
        mov \reg, r1
        .endr
        blx r0
        ldr r1, =harness_stack_pointer
        ldr r1, [r1]
        mov sp, r1
        vpop {s16-s31}
        pop {r4-r11, pc}
        .ltorg
    )");
}

bool takes_interrupts() {
    std::uint32_t mask = 0;
    std::uint32_t fault_mask = 0;
    std::uint32_t priority = 0;
    asm volatile("mrs %0, primask\n mrs %1, faultmask\n mrs %2, basepri"
                 : "=r"(mask), "=r"(fault_mask), "=r"(priority));
    return (mask | fault_mask | priority) == 0U;
}

void unmask_interrupts() {
    asm volatile("cpsie i\n cpsie f\n msr basepri, %0" ::"r"(0) : "memory");
}

void restore_system_registers() {
    constexpr std::uintptr_t vectors = 0xE000ED08U;         // VTOR
    constexpr std::uintptr_t configuration = 0xE000ED14U;   // CCR
    constexpr std::uintptr_t fault_handlers = 0xE000ED24U;  // SHCSR
    constexpr std::uint32_t stack_alignment = 1U << 9U;     // the only bit of CCR that is 1 after a reset
    registers_at<volatile std::uint32_t>(vectors) = 0U;
    registers_at<volatile std::uint32_t>(configuration) = stack_alignment;
    registers_at<volatile std::uint32_t>(fault_handlers) = 0U;
    asm volatile("vmsr fpscr, %0\n dsb\n isb" ::"r"(0) : "memory");
}

void arm_timer(std::uint32_t ticks) {
    target::sys_tick().control = 0U;
    target::sys_tick().reload = ticks == 0U ? 1U : ticks;
    target::sys_tick().value = 0U;
    target::sys_tick().control = interrupts;
}

void stop_timer() {
    target::sys_tick().control = 0U;
    registers_at<volatile std::uint32_t>(interrupt_control) = 1U << 25U;  // clears a pending interrupt of SysTick
}

/// QEMU's watchdog also counts while it is switched off, so that an old interrupt can wait.
void arm_watchdog(std::uint32_t ticks) {
    watchdog().load = ticks;
    watchdog().clear = 1U;
    watchdog().control = 1U;
}

void stop_watchdog() {
    watchdog().control = 0U;
}

void start_measurement() {
    target::sys_tick().control = 0U;
    target::sys_tick().reload = target::longest_sys_tick;
    target::sys_tick().value = 0U;
    target::sys_tick().control = counts;
}

std::uint32_t measured_ticks() {
    const std::uint32_t value = target::sys_tick().value;
    return value == 0U ? 0U : target::longest_sys_tick - value;
}

void turn_float_register(Interrupted& interrupted, bool has_floats, std::uint32_t number, std::uint32_t bit) {
    static std::uint32_t all[32];
    asm volatile("vstmia %0, {s0-s31}" ::"r"(&all[0]) : "memory");
    all[number] ^= 1U << bit;
    asm volatile("vldmia %0, {s0-s31}" ::"r"(&all[0]) : "memory");
    if (has_floats && number < 16U) {
        interrupted.s0_to_s15[number] ^= 1U << bit;
    }
}

void say(const char* text) {
    target::semihost(sys_write0, text);
}

void say_number(std::uint32_t number) {
    static char digits[12];
    std::uint32_t first = 11;
    digits[first] = '\0';
    do {
        digits[--first] = static_cast<char>('0' + (number % 10U));
        number /= 10U;
    } while (number != 0U);
    say(&digits[first]);
}

void end_emulation() {
    static const std::uint32_t exit[2]{0x20026U, 0U};
    target::semihost(sys_exit_extended, &exit);
    for (;;) {
    }
}

}  // namespace canproof::faults

std::uint32_t take_exception(canproof::faults::Interrupted* interrupted, std::uint32_t return_kind,
                             std::uint32_t number) {
    using namespace canproof::faults;
    if (number == hard_fault) {
        return access_was_watched(*interrupted) ? continues : ends_by_exception;
    }
    if (number == pend_sv) {
        resume_watch();
        return continues;
    }
    const bool has_floats = (return_kind & 0x10U) == 0U;
    return timer_fired(*interrupted, has_floats) ? continues : ends_hanging;
}

void begin_on_harness_stack() {
    canproof::faults::start_campaign();
}

void resume_after(std::uint32_t was_exception) {
    canproof::faults::resume(was_exception != 0U);
}

/// Switches from the stack of the start-up code to the stack of the harness.
[[gnu::naked]] void image_main() {
    asm volatile(R"(
        ldr r0, =harness_stack_top
        mov sp, r0
        b begin_on_harness_stack
        .ltorg
    )");
}

/// Handles each exception. The timer's interrupt (15) injects a fault. While a block of RAM is watched, a hard fault
/// (3) can be an access to it, and PendSV (14) continues the watch. After any other exception, and when a run hangs
/// (the watchdog's interrupt is 2), returns from the exception to resume_after(), by an artificial stack frame on the
/// stack of the harness.
[[gnu::naked]] void fault() {
    asm volatile(R"(
        mrs r2, ipsr
        mov r0, #0
        cmp r2, #2
        beq 1f
        cmp r2, #15
        beq 2f
        mov r0, #1
        ldr r1, =watch_is_on
        ldr r1, [r1]
        cmp r1, #0
        beq 1f
    2:  push {r4-r11}
        mov r0, sp
        mov r1, lr
        mov r4, lr
        mov r5, sp
        bic r6, r5, #7
        mov sp, r6
        bl take_exception
        mov sp, r5
        mov lr, r4
        cmp r0, #1
        pop {r4-r11}
        it eq
        bxeq lr
        lsr r0, r0, #1
    1:  cpsie i
        ldr r1, =harness_stack_top
        sub r1, #64
        mov sp, r1
        str r0, [r1]
        mov r2, #0
        str r2, [r1, #4]
        str r2, [r1, #8]
        str r2, [r1, #12]
        str r2, [r1, #16]
        str r2, [r1, #20]
        ldr r2, =resume_after
        bic r2, r2, #1
        str r2, [r1, #24]
        mov r2, #0x01000000
        str r2, [r1, #28]
        ldr r2, =0xE000EF34
        mov r3, #0
        ldr r0, [r2]
        bic r0, r0, #1
        str r0, [r2]
        mov lr, #0xFFFFFFF9
        bx lr
        .ltorg
    )");
}
