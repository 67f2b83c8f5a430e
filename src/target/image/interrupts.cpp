// SPDX-License-Identifier: Apache-2.0
// The vectors of the chip's interrupts, which follow the vectors of startup.cpp in flash, and the handler of all
// exceptions.
#include <array>

#include "target/image/image.hpp"

extern "C" {
[[noreturn]] void fault();
}

namespace {

using Handler = void (*)();
constexpr std::size_t can1_rx0 = 20;  // interrupt number (RM0090 12.1.3, Table 62)
constexpr std::size_t can1_rx1 = 21;

constexpr std::array<Handler, can1_rx1 + 1> make_interrupts() {
    std::array<Handler, can1_rx1 + 1> handlers{};
    for (Handler& one : handlers) {
        one = fault;  // no other interrupt is enabled
    }
    handlers[can1_rx0] = can_received;
    handlers[can1_rx1] = can_received;
    return handlers;
}

[[gnu::section(".vectors.interrupts"), gnu::used]] constexpr std::array<Handler, can1_rx1 + 1> interrupts =
    make_interrupts();

}  // namespace

/// Switches the outputs off and stops the processor. The watchdog, if it runs already, then resets the chip.
void fault() {
    device_failed();
    for (;;) {
        asm volatile("wfi");
    }
}
