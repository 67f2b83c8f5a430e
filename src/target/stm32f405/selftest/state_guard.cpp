// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/state_guard.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::size_t word = sizeof(std::uint32_t);

/// Adds the word at a position, which lies within the bytes.
[[gnu::always_inline]] inline std::uint32_t add_word(const std::uint32_t sum, const ByteView bytes,
                                                     const std::size_t at) noexcept {
    const std::uint32_t turned = (sum << 1U) | (sum >> 31U);
    return turned + static_cast<std::uint32_t>(load_le<word>(bytes.data() + at));
}

/// Adds eight words in each turn of the loop, because a device computes this sum twice in each pass.
std::uint32_t add(std::uint32_t sum, const ByteView bytes) noexcept {
    constexpr std::size_t block = 8U * word;
    std::size_t at{0U};
    for (; (bytes.size() - at) >= block; at += block) {
        sum = add_word(sum, bytes, at);
        sum = add_word(sum, bytes, at + word);
        sum = add_word(sum, bytes, at + (2U * word));
        sum = add_word(sum, bytes, at + (3U * word));
        sum = add_word(sum, bytes, at + (4U * word));
        sum = add_word(sum, bytes, at + (5U * word));
        sum = add_word(sum, bytes, at + (6U * word));
        sum = add_word(sum, bytes, at + (7U * word));
    }
    for (; at < bytes.size(); at += word) {
        sum = add_word(sum, bytes, at);
    }
    return sum;
}

}  // namespace

static_assert(implements<req::CO_SELF_011>);
std::uint32_t StateGuard::sum() const noexcept {
    return add(add(0U, device_), queue_);
}

}  // namespace canproof::stm32f405
