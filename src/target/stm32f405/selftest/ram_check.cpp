// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/ram_check.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/core.hpp"

namespace canproof::stm32f405 {

namespace {

/// Any two bits of a word differ in at least one of these backgrounds. In background n + 1, a bit of the word has the
/// value of bit n of its position.
constexpr std::array<std::uint32_t, RamCheck::background_count> backgrounds{0x00000000U, 0xAAAAAAAAU, 0xCCCCCCCCU,
                                                                            0xF0F0F0F0U, 0xFF00FF00U, 0xFFFF0000U};

enum class Order : std::uint8_t { upwards, downwards };

/// Does one element (step) of the March C- test: replaces `expected` by `next` in each word. Returns whether each word
/// contained `expected`.
bool replace_each(const Slots<Register>& words, const Order order, const std::uint32_t expected,
                  const std::uint32_t next) noexcept {
    bool holds{true};
    const std::size_t count = words.size();
    for (std::size_t i = 0U; i < count; ++i) {
        Register& word = words[(order == Order::upwards) ? i : ((count - 1U) - i)];
        holds = (word.read() == expected) && holds;
        word.write(next);
    }
    return holds;
}

/// Does the six elements of the March C- test. Returns whether each word had the expected contents at each element.
bool march(const Slots<Register>& words, const std::uint32_t background) noexcept {
    for (Register& word : words) {
        word.write(background);
    }
    bool holds = replace_each(words, Order::upwards, background, ~background);
    holds = replace_each(words, Order::upwards, ~background, background) && holds;
    holds = replace_each(words, Order::downwards, background, ~background) && holds;
    holds = replace_each(words, Order::downwards, ~background, background) && holds;
    for (const Register& word : words) {
        holds = (word.read() == background) && holds;
    }
    return holds;
}

}  // namespace

static_assert(implements<req::CO_SELF_001> && implements<req::CO_SELF_013>);
bool RamCheck::step() noexcept {
    const std::size_t left = ram_.words.size() - next_;
    const bool is_last = left <= ram_slice;
    const std::size_t count = is_last ? left : ram_slice;
    Register* const first = &ram_.words[next_];
    const auto length = static_cast<std::uint32_t>(count);
    const std::uint32_t background = backgrounds[passes_ % background_count];
    const bool meets_stack = (next_ < ram_.stack_end) && ((next_ + count) > ram_.stack_begin);
    const std::uint32_t mask = core_mask_interrupts();
    const bool holds = meets_stack ? ram_march(first, length, background)
                                   : core_march_on(first, length, background, &ram_.words[ram_.stack_end]);
    core_restore_interrupts(mask);
    if (is_last) {
        next_ = 0U;
        ++passes_;
    } else {
        next_ += count - 1U;
    }
    return holds;
}

bool RamCheck::pass() noexcept {
    bool holds{true};
    const std::uint32_t before = passes_;
    for (std::size_t i = 0U; (i < ram_.words.size()) && (passes_ == before); ++i) {
        holds = step() && holds;
    }
    return holds;
}

static_assert(implements<req::CO_SELF_014>);
bool ram_march(Register* first, const std::uint32_t count, const std::uint32_t background) noexcept {
    const Slots<Register> words{first, count};
    std::array<std::uint32_t, ram_slice> saved{};
    for (std::size_t i = 0U; i < count; ++i) {
        saved[i] = words[i].read();
    }
    bool holds = march(words, background);
    for (std::size_t i = 0U; i < count; ++i) {
        words[i].write(saved[i]);
    }
    for (std::size_t i = 0U; i < count; ++i) {
        holds = (words[i].read() == saved[i]) && holds;
    }
    return holds;
}

}  // namespace canproof::stm32f405
