// SPDX-License-Identifier: Apache-2.0
// The memory of a device's image: flash with its CRC (the seal), RAM, the stack and its guard words. The linker
// provides the addresses (stm32f405/device.ld).
#include "target/image/image.hpp"

extern "C" {
extern const std::uint8_t vectors_begin[];
extern const std::uint8_t vectors_end[];
extern const std::uint8_t image_begin[];
extern const std::uint8_t image_end[];
extern canproof::stm32f405::Register ram_begin[];
extern canproof::stm32f405::Register ram_test_stack_begin[];
extern canproof::stm32f405::Register ram_test_stack_end[];
extern canproof::stm32f405::Register stack_limit[];
extern canproof::stm32f405::Register stack_top[];
}

namespace canproof::target {

namespace {

using stm32f405::Register;

constexpr std::size_t guard_words = 4;

/// The CRC of the image; src/target/image/seal writes it here.
[[gnu::section(".seal"), gnu::used]] const volatile std::uint32_t seal = 0xFFFFFFFFU;

/// The record of the self-test that failed before a reset. The start-up code does not initialise it.
[[gnu::section(".noinit")]] stm32f405::FailureWords kept;

ByteView between(const std::uint8_t* begin, const std::uint8_t* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

stm32f405::ImageMemory image_memory() {
    const stm32f405::RamUnderTest ram{Slots<Register>{ram_begin, static_cast<std::size_t>(stack_top - ram_begin)},
                                      static_cast<std::size_t>(ram_test_stack_begin - ram_begin),
                                      static_cast<std::size_t>(ram_test_stack_end - ram_begin)};
    return {between(vectors_begin, vectors_end), between(image_begin, image_end), ram,
            Slots<Register>{stack_limit, guard_words}};
}

stm32f405::FailureWords& failure_words() {
    return kept;
}

}  // namespace canproof::target
