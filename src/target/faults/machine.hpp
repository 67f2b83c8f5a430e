// SPDX-License-Identifier: Apache-2.0
// The functions of the processor that the harness needs: separate stacks for the device and the harness, a timer that
// interrupts the device, exceptions, and lines of text to the host.
#pragma once

#include <cstdint>

namespace canproof::faults {

constexpr std::uintptr_t interrupt_control = 0xE000ED04U;  ///< ICSR: sets and clears pending exceptions

/// The registers of the interrupted device: r4 to r11, then those that the processor puts on the stack at an interrupt.
struct Interrupted {
    std::uint32_t r4_to_r11[8];
    std::uint32_t r0_to_r3[4];
    std::uint32_t r12;
    std::uint32_t lr;
    std::uint32_t pc;
    std::uint32_t flags;
    std::uint32_t s0_to_s15[16];  ///< only when has_floats
};

/// Calls `run` on the stack of the device. Returns when `run` returns.
void run_on_device_stack(void (*run)());
/// Returns whether the processor accepts interrupts (they are not masked).
bool takes_interrupts();
/// Makes the processor accept all interrupts and exceptions again, whatever the device has masked.
void unmask_interrupts();
/// Gives the registers of the processor that a device with a fault may have changed their values after a reset: place
/// of the vectors, configuration, handlers of faults, and the mode of the floating-point unit.
void restore_system_registers();
/// Interrupts the device after about `ticks` of the timer (1.25 instructions each).
void arm_timer(std::uint32_t ticks);
void stop_timer();
/// Ends the run as hanging after `ticks` of the timer, even if the device masks interrupts. Until stop_watchdog().
void arm_watchdog(std::uint32_t ticks);
void stop_watchdog();
void start_measurement();
std::uint32_t measured_ticks();
/// Inverts a bit of s0 to s31. `interrupted` has s0 to s15 when `has_floats`.
void turn_float_register(Interrupted& interrupted, bool has_floats, std::uint32_t number, std::uint32_t bit);
void say(const char* text);
void say_number(std::uint32_t number);
[[noreturn]] void end_emulation();

// The functions that campaign.cpp and watch.cpp define.

/// Injects the fault when the timer interrupts the device. Returns true to continue the device, false to end the run as
/// hanging.
bool timer_fired(Interrupted& interrupted, bool has_floats);
/// Returns whether the hard fault is a use of the watched blocks (watch.hpp). The device then repeats the instruction.
bool access_was_watched(const Interrupted& interrupted);
/// Continues after an exception of the processor or a hanging run, on the stack of the harness.
[[noreturn]] void resume(bool was_exception);
[[noreturn]] void start_campaign();

}  // namespace canproof::faults
