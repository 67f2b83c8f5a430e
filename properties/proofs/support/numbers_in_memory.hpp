// SPDX-License-Identifier: Apache-2.0
// Little-endian numbers in memory, read and written byte by byte as they are defined. Theorems compare the firmware
// with these.
#pragma once

#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

constexpr std::size_t longest = 8U;

/// Returns byte `at` of a number, counted from the least significant byte.
inline std::uint8_t byte_of(const std::uint64_t number, const std::size_t at) {
    return static_cast<std::uint8_t>((number >> (8U * at)) & 0xFFU);
}

/// One byte of memory that a theorem looks at before and after a number is written. Where the number was written it
/// must be a byte of the number; elsewhere it must be unchanged.
struct Looked {
    std::uint8_t* memory;
    std::size_t size;
    std::size_t at;
    std::uint8_t before;
};

inline Looked look() {
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t at = any<std::size_t>();
    assume(at < size);
    return {memory, size, at, memory[at]};
}

inline void claim_put(const Looked& looked, const std::size_t at, const std::size_t count, const std::uint64_t value) {
    const bool written = (looked.at >= at) && ((looked.at - at) < count);
    claim(looked.memory[looked.at] == (written ? byte_of(value, looked.at - at) : looked.before));
}

template <std::size_t N>
void put_and_look() {
    const Looked looked = look();
    const std::size_t at = any<std::size_t>();
    const std::uint64_t value = any<std::uint64_t>();
    MutableBytes{looked.memory, looked.size}.put_le<N>(at, value);
    claim_put(looked, at, N, value);
}

/// Returns the number that `count` bytes from position `at` on represent; bytes beyond the end of the view count as
/// zero.
inline std::uint64_t number_at(const ByteView bytes, const std::size_t at, const std::size_t count) {
    std::uint64_t number{0U};
    for (std::size_t i = 0U; i < longest; ++i) {
        const bool there = (i < count) && (at < bytes.size()) && ((at + i) < bytes.size());
        number |= there ? (std::uint64_t{bytes[at + i]} << (8U * i)) : 0U;
    }
    return number;
}

struct Read {
    ByteView view;
    std::size_t at;
};

inline Read any_read() {
    const std::size_t size = any_size();
    return {ByteView{any_memory(size), size}, any<std::size_t>()};
}

}  // namespace canproof::proofs
