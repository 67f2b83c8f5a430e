// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/core_model.hpp"

#include <cstring>

#include "target/stm32f405/selftest/core.hpp"

namespace canproof::test {

CoreModel& core_model() {
    static CoreModel core;
    return core;
}

}  // namespace canproof::test

namespace canproof::stm32f405 {

using test::core_model;

std::uint32_t core_mask_interrupts() noexcept {
    const std::uint32_t before = core_model().masked ? 1 : 0;
    core_model().masked = true;
    return before;
}

void core_restore_interrupts(std::uint32_t mask) noexcept {
    core_model().masked = mask != 0;
}

bool core_registers_hold() noexcept {
    return core_model().registers_hold;
}

bool core_march_on(Register* first, std::uint32_t count, std::uint32_t background, Register* stack_end) noexcept {
    ++core_model().marches;
    core_model().stack_end = stack_end;
    return ram_march(first, count, background);
}

std::uint32_t core_sum(std::uint32_t sum, const std::uint8_t* words, std::uint32_t count) noexcept {
    for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t word = 0;
        std::memcpy(&word, words + i * sizeof word, sizeof word);
        sum = (sum << 1 | sum >> 31) + word;
    }
    return sum;
}

}  // namespace canproof::stm32f405
