// SPDX-License-Identifier: Apache-2.0
// Start-up of a Cortex-A53 from its reset to image_main(). The core starts in the 64-bit state of exception level 2.
// Five instructions prepare the 32-bit state of level 1 (Arm DDI 0487, D1.18); from there on all code is 32-bit.
#include <cstdint>

extern "C" {

extern std::uint32_t bss_start[];
extern std::uint32_t bss_end[];
using Constructor = void (*)();
extern const Constructor __preinit_array_start[];
extern const Constructor __init_array_end[];

void reset();
void fault();
void image_main();
[[noreturn]] void start_image();
}

/// The assembler of this compiler has no 64-bit instructions, so they are written as numbers. The 32-bit instructions
/// behind them set up the stack, the vectors and the access to the floating-point unit (CPACR, FPEXC).
asm(R"(
    .section .start, "ax", %progbits
    .arm
    .global reset
reset:
    .word 0xD2800000    @ mov x0, #0
    .word 0xD51C1100    @ msr HCR_EL2, x0: level 1 is 32-bit
    .word 0xD2803A60    @ mov x0, #0x1D3: supervisor mode, Arm state, all interrupts masked
    .word 0xD51C4000    @ msr SPSR_EL2, x0
    .word 0x10000060    @ adr x0, to the instruction after eret
    .word 0xD51C4020    @ msr ELR_EL2, x0
    .word 0xD69F03E0    @ eret
    ldr sp, =stack_top
    ldr r0, =exceptions
    mcr p15, 0, r0, c12, c0, 0
    mrc p15, 0, r0, c1, c0, 2
    orr r0, r0, #(0xF << 20)
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #(1 << 30)
    vmsr fpexc, r0
    ldr r0, =start_image
    bx r0
    .ltorg
    .balign 32
exceptions:
    .rept 8
    ldr pc, =fault
    .endr
    .ltorg
    .text
)");

void start_image() {
    for (std::uint32_t* to = bss_start; to != bss_end; ++to) {
        *to = 0U;
    }
    for (const Constructor* one = __preinit_array_start; one != __init_array_end; ++one) {
        (*one)();
    }
    image_main();
    fault();
    for (;;) {
    }
}
