// SPDX-License-Identifier: Apache-2.0
// A test of RAM that keeps its contents: March C- over slices of a few words. The elements of the march, with a
// background b: write b to each word; upwards read b, write ~b; upwards read ~b, write b; the same two downwards; read
// b.
#pragma once

#include "firmware/base/slots.hpp"
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

/// Number of words of a slice. Interrupts are masked while a slice is tested.
constexpr std::uint32_t ram_slice = 4U;

/// RAM that is tested. The words from `stack_begin` to `stack_end` contain no variable and serve as a stack. The march
/// over the other words runs on this stack, so that the march can alter the words of the caller's stack.
struct RamUnderTest {
    Slots<Register> words;
    std::size_t stack_begin{0U};  ///< position in `words`
    std::size_t stack_end{0U};
};

/// One pass over the words finds each bit that is stuck or makes no transition, each word that another address
/// of its slice reaches, and the coupling between neighbouring words. Passes alternate between six backgrounds. Any two
/// bits of a word differ in at least one of these backgrounds, so that six passes also find the coupling between the
/// bits of a word.
class RamCheck {
  public:
    static constexpr std::uint32_t background_count = 6U;

    explicit RamCheck(const RamUnderTest& ram) noexcept : ram_{ram} {}

    /// Tests the next slice, which begins with the last word of the previous slice. Returns false when a word fails.
    bool step() noexcept;
    /// Tests every slice once, with the next background.
    bool pass() noexcept;
    /// Returns the number of completed passes over all words.
    std::uint32_t passes() const noexcept { return passes_; }

  private:
    RamUnderTest ram_;
    std::size_t next_{0U};
    std::uint32_t passes_{0U};
};

}  // namespace canproof::stm32f405
