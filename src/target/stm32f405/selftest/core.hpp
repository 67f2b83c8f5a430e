// SPDX-License-Identifier: Apache-2.0
// Functions of the core that C++ cannot express, for self-tests: src/target/image/core.cpp has them for the processor.
// A test links other definitions (tests/support/stm32f405).
#pragma once

#include <cstdint>

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

/// Masks the interrupts. Returns the previous mask, for core_restore_interrupts().
std::uint32_t core_mask_interrupts() noexcept;
void core_restore_interrupts(std::uint32_t mask) noexcept;

/// Writes patterns into r0 to r12, lr, the flags and s0 to s31 and reads them back. Returns whether all of them match.
bool core_registers_hold() noexcept;

/// Calls ram_march(first, count, background) on another stack, which ends at `stack_end`, and returns its result.
bool core_march_on(Register* first, std::uint32_t count, std::uint32_t background, Register* stack_end) noexcept;

/// Adds `count` words from an address that is a multiple of four to a checksum: for each word, rotates the checksum
/// left by one bit and adds the word.
std::uint32_t core_sum(std::uint32_t sum, const std::uint8_t* words, std::uint32_t count) noexcept;

/// Tests at most ram_slice words of RAM from `first` on by March C-; see ram_check.hpp.
bool ram_march(Register* first, std::uint32_t count, std::uint32_t background) noexcept;

}  // namespace canproof::stm32f405
