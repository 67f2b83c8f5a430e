// SPDX-License-Identifier: Apache-2.0
// Handles eight ASCII characters at a time, because a data sheet has about a hundred bytes for each entry.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace canproof::host {

namespace eight_characters {

constexpr std::uint64_t each = 0x0101010101010101;  ///< multiplied by a byte: eight copies of the byte
constexpr std::uint64_t highest_bits = 0x80 * each;

/// Returns a word in which bit 7 of a byte is set if the lower 7 bits of the character in this byte are at least
/// `first`. All other bits are 0. `first` is at most 7Fh.
constexpr std::uint64_t at_least(std::uint64_t text, std::uint64_t first) {
    return ((text & (0x7F * each)) + (0x80 - first) * each) & highest_bits;
}

constexpr std::size_t size = sizeof(std::uint64_t);

inline std::uint64_t load(const char* from) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, size);
    return word;
}

}  // namespace eight_characters

/// Returns whether the text contains a control character other than a tab.
inline bool has_control(std::string_view text) {
    using namespace eight_characters;
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20U && c != '\t'; };
    const auto has_low = [&text](std::size_t at) {
        const std::uint64_t word = load(text.data() + at);
        return ((at_least(word, 0x20) | word) & highest_bits) != highest_bits;
    };
    bool may_have = text.size() < size || has_low(text.size() - size);
    for (std::size_t at = 0; at + size < text.size() && !may_have; at += size) {
        may_have = has_low(at);
    }
    return may_have && std::any_of(text.begin(), text.end(), is_control);
}

/// Returns the lower-case letter for `A` to `Z`, and any other byte unchanged.
constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Converts `count` characters from `begin` on to lower case.
inline void make_lower_case(char* begin, std::size_t count) {
    using namespace eight_characters;
    const auto lower_eight = [](char* at) {
        const std::uint64_t word = load(at);
        const std::uint64_t capitals = at_least(word, 'A') & ~at_least(word, 'Z' + 1) & ~word;
        // shifts 80h to 20h, the bit in which small and capital letters differ
        const std::uint64_t lower = word | (capitals >> 2U);
        std::memcpy(at, &lower, size);
    };
    if (count < size) {
        std::transform(begin, begin + count, begin, [](char c) { return lower_case(c); });
        return;
    }
    for (std::size_t at = 0; at + size < count; at += size) {
        lower_eight(begin + at);
    }
    lower_eight(begin + count - size);  // the last eight characters, some of which may be converted twice
}

}  // namespace canproof::host
