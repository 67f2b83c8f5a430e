// SPDX-License-Identifier: Apache-2.0
// Theorems on bytes whose proofs take longer: for longer numbers, any number of bytes, whole copies, and the CRC-16 of
// more than one byte.
#include "firmware/base/bytes.hpp"

#include "firmware/base/crc16.hpp"
#include "properties/proofs/support/numbers_in_memory.hpp"

namespace canproof::proofs {

void put_le_puts_4_bytes() {
    shows("put_le<4>() puts 4 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<4U>();
}

void put_le_puts_8_bytes() {
    shows("put_le<8>() puts 8 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<8U>();
}

void set_le_puts_what_fits() {
    shows("set_le() and write_le() put 0 to 8 bytes, the least significant first, and change nothing else");
    const Looked looked = look();
    const std::size_t at = any<std::size_t>();
    const std::size_t count = any<std::size_t>();
    assume(count <= longest);
    const std::uint64_t value = any<std::uint64_t>();
    write_le(MutableBytes{looked.memory, looked.size}, at, count, value);
    claim_put(looked, at, count, value);
}

void get_le_reads_4_bytes() {
    shows("get_le<4>() and read_u32() read 4 bytes, the least significant first; those outside are zero");
    const Read read = any_read();
    claim(get_le<4U>(read.view, read.at) == number_at(read.view, read.at, 4U));
    claim(read_u32(read.view, read.at) == number_at(read.view, read.at, 4U));
}

void get_le_reads_8_bytes() {
    shows("get_le<8>() reads 8 bytes, the least significant first; those outside are zero");
    const Read read = any_read();
    claim(get_le<8U>(read.view, read.at) == number_at(read.view, read.at, 8U));
}

void read_le_reads_what_is_there() {
    shows("read_le() and join_each() read 0 to 8 bytes, the least significant first; those outside are zero");
    const Read read = any_read();
    const std::size_t count = any<std::size_t>();
    assume(count <= longest);
    const std::uint64_t number = number_at(read.view, read.at, count);
    claim(read_le(read.view, read.at, count) == number);
    claim(join_each(read.view, read.at, count) == number);
}

void copying_drops_what_does_not_fit() {
    shows("copy() moves the source to its position, byte by byte, drops what does not fit and changes nothing else");
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t length = any_size();
    const std::uint8_t* const source = any_memory(length);
    const std::size_t at = any<std::size_t>();
    const std::size_t looked_at = any<std::size_t>();
    assume(looked_at < size);
    const std::uint8_t before = memory[looked_at];
    MutableBytes{memory, size}.copy(at, ByteView{source, length});
    const bool copied = (looked_at >= at) && ((looked_at - at) < length);
    claim(memory[looked_at] == (copied ? source[looked_at - at] : before));
}

void crc16_of_bytes_is_that_of_the_first_and_the_rest() {
    shows("CRC-16 of 1 to 8 bytes is that of the first byte, then of the rest, in every state");
    auto bytes = any<std::array<std::uint8_t, 8U>>();
    const std::size_t size = any<std::size_t>();
    assume((size >= 1U) && (size <= bytes.size()));
    Crc16 whole{};
    whole.remainder_ = any<std::uint16_t>();
    Crc16 parts = whole;
    const ByteView view = ByteView{bytes}.part(0U, size);
    whole.add(view);
    parts.add(view.part(0U, 1U));
    parts.add(view.part(1U, size - 1U));
    claim(whole.remainder_ == parts.remainder_);
}

}  // namespace canproof::proofs
