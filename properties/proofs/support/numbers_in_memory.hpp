// SPDX-License-Identifier: Apache-2.0
// Little-endian numbers in memory of any size, at any position. Theorems compare the firmware with their bytes.
#pragma once

#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

constexpr std::size_t longest = 8U;

/// Returns byte `at` of a number, counted from the least significant byte.
inline std::uint8_t byte_of(const std::uint64_t number, const std::size_t at) {
    return static_cast<std::uint8_t>((number >> (8U * at)) & 0xFFU);
}

/// Memory of any size, and `count` bytes of it from any position on; the first `there` of them lie in the memory. The
/// prover proves a theorem separately for each number `there`.
struct Span {
    std::uint8_t* memory;
    std::size_t size;
    std::size_t at;
    std::size_t count;
    std::size_t there;

    ByteView view() const { return ByteView{memory, size}; }
    MutableBytes bytes() const { return MutableBytes{memory, size}; }
    /// Returns the number that the bytes represent, the least significant first; those outside count as zero.
    std::uint64_t number() const {
        std::uint64_t sum{0U};
        for (std::size_t i = 0U; i < there; ++i) {
            sum |= std::uint64_t{memory[at + i]} << (8U * i);
        }
        return sum;
    }
};

/// Returns `count` bytes from a position on at which the first `there` of them lie in memory of any size. Without
/// `goes_on`, the memory ends behind these; with it, behind any number of bytes more. positions_inside_have_32_bits()
/// shows that each position inside of the memory is one of these.
inline Span span_inside(const std::size_t count, const std::size_t there, const bool goes_on) {
    const std::size_t at = any<std::uint32_t>();
    const std::size_t behind = goes_on ? (std::size_t{any<std::uint32_t>()} + 1U) : 0U;
    const std::size_t size = at + there + behind;
    assume(size <= most_memory);
    return {any_memory(size), size, at, count, there};
}

/// Returns `count` bytes of which none lies in memory of any size: at any position behind it, or no bytes at any
/// position.
inline Span span_outside(const std::size_t count) {
    const std::size_t size = any_size();
    const std::size_t at = any<std::size_t>();
    assume((count == 0U) || (at >= size));
    return {any_memory(size), size, at, count, 0U};
}

/// Returns `count` bytes from any position on, in memory of any size or behind it.
inline Span any_span(const std::size_t count) {
    const std::size_t number = each(count + 2U);
    if (number == 0U) {
        return span_outside(count);
    }
    const bool goes_on = number > count;
    return span_inside(count, goes_on ? count : number, goes_on);
}

/// Returns `count` bytes from any position on at which all of them lie in memory of any size.
inline Span any_whole_span(const std::size_t count) {
    return span_inside(count, count, each(2U) == 1U);
}

/// One byte of memory outside a span, which must keep its value. The memory has at most 2^32 bytes.
struct Other {
    std::size_t at;
    std::uint8_t before;
    bool is_one;  ///< whether it exists: at that position, the memory has a byte outside the span
};

inline Other any_other(const Span& span) {
    const std::size_t at = any<std::uint32_t>();
    const bool is_one = (at < span.size) && ((at < span.at) || ((at - span.at) >= span.count));
    return {at, span.view()[at], is_one};
}

/// Claims that the bytes of the span in the memory are those of `value`, and that no other byte has changed.
inline void claim_put(const Span& span, const Other& other, const std::uint64_t value) {
    for (std::size_t i = 0U; i < span.there; ++i) {
        claim(span.memory[span.at + i] == byte_of(value, i));
    }
    claim(!other.is_one || (span.view()[other.at] == other.before));
}

template <std::size_t N>
void put_and_look() {
    const Span span = any_span(N);
    const Other other = any_other(span);
    const std::uint64_t value = any<std::uint64_t>();
    span.bytes().put_le<N>(span.at, value);
    claim_put(span, other, value);
}

template <std::size_t N>
void get_and_compare() {
    const Span span = any_span(N);
    claim(get_le<N>(span.view(), span.at) == span.number());
}

}  // namespace canproof::proofs
