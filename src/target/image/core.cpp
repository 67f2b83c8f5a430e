// SPDX-License-Identifier: Apache-2.0
// The functions of stm32f405/selftest/core.hpp that C++ cannot express, for a Cortex-M4 with its floating-point unit.
#include "target/stm32f405/selftest/core.hpp"

extern "C" {
/// Calls ram_march(). The assembler code below can call this function by its unmangled name.
bool march_here(canproof::stm32f405::Register* first, std::uint32_t count, std::uint32_t background) {
    return canproof::stm32f405::ram_march(first, count, background);
}
}

namespace canproof::stm32f405 {

std::uint32_t core_mask_interrupts() noexcept {
    std::uint32_t mask;
    asm volatile("mrs %0, primask\n cpsid i" : "=r"(mask)::"memory");
    return mask;
}

void core_restore_interrupts(std::uint32_t mask) noexcept {
    asm volatile("msr primask, %0" ::"r"(mask) : "memory");
}

/// Keeps the stack pointer of the caller in r4, which march_here() preserves.
[[gnu::naked]] bool core_march_on(Register*, std::uint32_t, std::uint32_t, Register*) noexcept {
    asm volatile(R"(
        push {r4, lr}
        mov r4, sp
        mov sp, r3
        bl march_here
        mov sp, r4
        pop {r4, pc}
    )");
}

/// Loads eight words with one instruction; one more instruction for each word rotates the sum and adds the word. The
/// first loop adds 32 words in each iteration, the second loop eight, and the third loop one.
[[gnu::naked]] std::uint32_t core_sum(std::uint32_t, const std::uint8_t*, std::uint32_t) noexcept {
    asm volatile(R"(
        .macro add_eight
        ldmia r1!, {r4-r11}
        .irp reg, r4, r5, r6, r7, r8, r9, r10, r11
        add.w r0, \reg, r0, ror #31
        .endr
        .endm
        push {r4-r11}
        b 2f
    1:  add_eight
        add_eight
        add_eight
        add_eight
    2:  subs r2, r2, #32
        bhs 1b
        adds r2, r2, #32
        b 4f
    3:  add_eight
    4:  subs r2, r2, #8
        bhs 3b
        adds r2, r2, #8
        b 6f
    5:  ldr r3, [r1], #4
        add.w r0, r3, r0, ror #31
    6:  subs r2, r2, #1
        bhs 5b
        pop {r4-r11}
        bx lr
        .purgem add_eight
    )");
}

/// Writes each pattern to all of r0 to r12 and lr, and checks that each of these registers has it. Then each of them,
/// and each of s0 to s31, gets a different number, so that a write that reaches a wrong register is noticed. The flags
/// are all set, then all clear; they are checked by their bits and by branches.
[[gnu::naked]] bool core_registers_hold() noexcept {
    asm volatile(R"(
        push {r4-r11, lr}
        vpush {s16-s31}

        .irp pattern, 0xAAAAAAAA, 0x55555555
        .irp reg, r0, r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, lr
        mov.w \reg, #\pattern
        .endr
        .irp reg, r0, r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, lr
        cmp.w \reg, #\pattern
        bne.w 9f
        .endr
        .endr

        .set number, 0
        .irp reg, r0, r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, lr
        .set number, number + 0x11111111
        mov.w \reg, #(number & 0xFF) * 0x01010101
        .endr
        .set number, 0
        .irp reg, r0, r1, r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, lr
        .set number, number + 0x11111111
        cmp.w \reg, #(number & 0xFF) * 0x01010101
        bne.w 9f
        .endr

        .irp pattern, 0xAAAAAAAA, 0x55555555
        mov.w r0, #\pattern
        .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
        vmov s\n, r0
        add.w r0, r0, #1
        .endr
        mov.w r0, #\pattern
        .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
        vmov r1, s\n
        cmp r0, r1
        bne.w 9f
        add.w r0, r0, #1
        .endr
        .endr

        mov.w r0, #0xF8000000
        msr APSR_nzcvq, r0
        bpl.w 9f
        bne.w 9f
        bcc.w 9f
        bvc.w 9f
        mrs r1, APSR
        and r1, r1, #0xF8000000
        cmp r0, r1
        bne.w 9f
        mov.w r0, #0
        msr APSR_nzcvq, r0
        bmi.w 9f
        beq.w 9f
        bcs.w 9f
        bvs.w 9f
        mrs r1, APSR
        tst r1, #0xF8000000
        bne.w 9f

        mov r0, #1
        b.n 8f
    9:  mov r0, #0
    8:  vpop {s16-s31}
        pop {r4-r11, pc}
    )");
}

}  // namespace canproof::stm32f405
