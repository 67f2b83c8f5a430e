// SPDX-License-Identifier: Apache-2.0
// Start-up from reset to image_main(): switches the floating-point unit on, initialises variables, runs constructors.
#include <cstddef>
#include <cstdint>

extern "C" {

extern std::uint32_t data_image[];
extern std::uint32_t data_start[];
extern std::uint32_t data_end[];
extern std::uint32_t bss_start[];
extern std::uint32_t bss_end[];
extern std::uint32_t stack_top[];
using Constructor = void (*)();
extern const Constructor __preinit_array_start[];
extern const Constructor __init_array_end[];

[[noreturn]] void reset();
[[noreturn]] void fault();
void image_main();
}

namespace {

/// Coprocessor access control of ARMv7-M: bits 20 to 23 give full access to the floating-point unit.
constexpr std::uintptr_t cpacr = 0xE000ED88U;

void fpu_on() {
    auto* const access = reinterpret_cast<volatile std::uint32_t*>(cpacr);
    *access = *access | (0xFU << 20U);
    asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

void reset() {
    fpu_on();
    const std::uint32_t* from = data_image;
    for (std::uint32_t* to = data_start; to != data_end; ++to) {
        *to = *from;
        ++from;
    }
    for (std::uint32_t* to = bss_start; to != bss_end; ++to) {
        *to = 0U;
    }
    for (const Constructor* one = __preinit_array_start; one != __init_array_end; ++one) {
        (*one)();
    }
    image_main();
    fault();
}

/// Stops the processor; only a reset starts it again. The images with drivers replace this function
/// (image/interrupts.cpp), and so do the test images, which end QEMU (tests/semihosting.cpp).
[[gnu::weak]] void fault() {
    for (;;) {
        asm volatile("wfi");
    }
}

namespace {

using Handler = void (*)();

/// The table that ARMv7-M reads at reset and at the fifteen system exceptions.
struct Vectors {
    const std::uint32_t* stack;
    Handler handlers[15];
};

[[gnu::section(".vectors"), gnu::used]] const Vectors vectors{
    stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};

}  // namespace
