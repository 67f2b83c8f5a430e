// SPDX-License-Identifier: Apache-2.0
// The parts of a device's image beside startup.cpp: the interrupts of the chip and the check of the flash. The linker
// provides the addresses (stm32f405/device.ld).
#include <array>

#include "target/image/image.hpp"
#include "target/stm32f405/image_check.hpp"

extern "C" {
extern const std::uint8_t vectors_begin[];
extern const std::uint8_t vectors_end[];
extern const std::uint8_t image_begin[];
extern const std::uint8_t image_end[];
[[noreturn]] void fault();
}

namespace {

using Handler = void (*)();
constexpr std::size_t can1_rx0 = 20;  // when this fails, a commit has to erase or reports a failure
constexpr std::size_t can1_rx1 = 21;

constexpr std::array<Handler, can1_rx1 + 1> make_interrupts() {
    std::array<Handler, can1_rx1 + 1> handlers{};
    for (Handler& one : handlers) {
        one = fault;  // not enabled
    }
    handlers[can1_rx0] = can_received;
    handlers[can1_rx1] = can_received;
    return handlers;
}

[[gnu::section(".vectors.interrupts"), gnu::used]] constexpr std::array<Handler, can1_rx1 + 1> interrupts =
    make_interrupts();

/// The CRC of the image; src/target/image/seal writes it here.
[[gnu::section(".seal"), gnu::used]] const volatile std::uint32_t seal = 0xFFFFFFFFU;

canproof::ByteView between(const std::uint8_t* begin, const std::uint8_t* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

namespace canproof::target {

bool is_sound() {
    return stm32f405::is_sound_image(between(vectors_begin, vectors_end), between(image_begin, image_end));
}

}  // namespace canproof::target
