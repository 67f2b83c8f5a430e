// SPDX-License-Identifier: Apache-2.0
#include "target/faults/machine.hpp"

#include "target/semihost.hpp"
#include "target/stm32f405/register.hpp"

extern "C" {
extern std::uint32_t stack_top[];
extern std::uint32_t harness_stack_top[];
std::uint32_t harness_stack_pointer;
void fault();
void image_main();
[[noreturn]] void begin_on_harness_stack();
[[noreturn]] void resume_after(std::uint32_t was_exception);
std::uint32_t timer_interrupt(canproof::faults::Interrupted* interrupted, std::uint32_t return_kind);
}

namespace canproof::faults {

namespace {

/// System timer of ARMv7-M.
struct SysTick {
    volatile std::uint32_t control;
    volatile std::uint32_t reload;
    volatile std::uint32_t value;
};

SysTick& timer() {
    constexpr std::uintptr_t address = 0xE000E010U;
    return *reinterpret_cast<SysTick*>(address);
}

constexpr std::uint32_t longest = 0x00FFFFFFU;
constexpr std::uint32_t counts = 5U;      // the timer is enabled and counts the processor clock
constexpr std::uint32_t interrupts = 7U;  // as `counts`; in addition, the timer raises an interrupt at 0
constexpr int sys_write0 = 0x04;
constexpr int sys_exit_extended = 0x20;

}  // namespace

/// Saves all registers that a function must preserve, s16 to s31 included, because a device with a fault may not
/// restore them.
[[gnu::naked]] void run_on_device_stack(void (*)()) {
    asm volatile(R"(
        push {r4-r11, lr}
        vpush {s16-s31}
        ldr r1, =harness_stack_pointer
        str sp, [r1]
        ldr r1, =stack_top
        mov sp, r1
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

void arm_timer(std::uint32_t ticks) {
    timer().control = 0U;
    timer().reload = ticks == 0U ? 1U : ticks;
    timer().value = 0U;
    timer().control = interrupts;
}

void stop_timer() {
    timer().control = 0U;
    constexpr std::uintptr_t interrupt_control = 0xE000ED04U;
    *reinterpret_cast<volatile std::uint32_t*>(interrupt_control) = 1U << 25U;  // clears a pending interrupt of SysTick
}

void start_measurement() {
    timer().control = 0U;
    timer().reload = longest;
    timer().value = 0U;
    timer().control = counts;
}

std::uint32_t measured_ticks() {
    const std::uint32_t value = timer().value;
    return value == 0U ? 0U : longest - value;
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

std::uint32_t timer_interrupt(canproof::faults::Interrupted* interrupted, std::uint32_t return_kind) {
    const bool has_floats = (return_kind & 0x10U) == 0U;
    return canproof::faults::timer_fired(*interrupted, has_floats) ? 1U : 0U;
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

/// Handles each exception. The timer's interrupt (15) injects a fault. After any other exception, and when a run
/// hangs, returns from the exception to resume_after(), by an artificial stack frame on the stack of the harness.
[[gnu::naked]] void fault() {
    asm volatile(R"(
        mrs r0, ipsr
        cmp r0, #15
        mov r0, #1
        bne 1f
        push {r4-r11}
        mov r0, sp
        mov r1, lr
        mov r4, lr
        mov r5, sp
        bic r6, r5, #7
        mov sp, r6
        bl timer_interrupt
        mov sp, r5
        mov lr, r4
        cmp r0, #0
        pop {r4-r11}
        it ne
        bxne lr
        mov r0, #0
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
