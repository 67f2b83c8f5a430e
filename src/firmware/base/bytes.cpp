// SPDX-License-Identifier: Apache-2.0
#include "firmware/base/bytes.hpp"

namespace canproof {

// The sum of `at` and a count of at most eight cannot overflow if `at` lies inside the view. Outside the view the sum
// could overflow, so put_each() checks `at` first.
void MutableBytes::put_each(const std::size_t at, const std::size_t count, const std::uint64_t value) noexcept {
    std::uint64_t rest{value};
    for (std::size_t i = 0U; (at < size_) && (i < count); ++i) {
        set(at + i, static_cast<std::uint8_t>(rest & 0xFFU));
        rest >>= 8U;
    }
}

bool MutableBytes::exchange_each(const std::size_t at, const std::size_t count, const std::uint64_t value) noexcept {
    const bool differs = join_each(view(), at, count) != value;
    if (differs) {
        put_each(at, count, value);
    }
    return differs;
}

std::uint64_t join_each(const ByteView bytes, const std::size_t at, const std::size_t count) noexcept {
    const ByteView present = bytes.part(at, count);
    std::uint64_t value{0U};
    for (std::size_t i = present.size(); i > 0U; --i) {
        value = (value << 8U) | present[i - 1U];
    }
    return value;
}

}  // namespace canproof
