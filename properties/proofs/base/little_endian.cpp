// SPDX-License-Identifier: Apache-2.0
// Theorems on numbers in memory, least significant byte first (CiA 301, 7.1.4), for memory of any size and any
// position.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/numbers_in_memory.hpp"

namespace canproof::proofs {

void put_le_puts_1_byte() {
    shows("put_le<1>() puts its byte at its position and changes nothing else; outside it does nothing");
    put_and_look<1U>();
}
void put_le_puts_2_bytes() {
    shows("put_le<2>() puts 2 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<2U>();
}
void put_le_puts_3_bytes() {
    shows("put_le<3>() puts 3 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<3U>();
}

void get_le_reads_1_byte() {
    shows("get_le<1>() reads the byte at its position, and zero outside");
    const Read read = any_read();
    claim(get_le<1U>(read.view, read.at) == number_at(read.view, read.at, 1U));
}
void get_le_reads_2_bytes() {
    shows("get_le<2>() and read_u16() read 2 bytes, the least significant first; those outside are zero");
    const Read read = any_read();
    claim(get_le<2U>(read.view, read.at) == number_at(read.view, read.at, 2U));
    claim(read_u16(read.view, read.at) == number_at(read.view, read.at, 2U));
}

void fields_of_arrays_are_their_bytes() {
    shows("field_le() and set_field_le() reach the bytes of their field and no others");
    auto bytes = any<std::array<std::uint8_t, 8U>>();
    const std::array<std::uint8_t, 8U> before = bytes;
    claim((field_le<1U, 3U>(bytes)) == number_at(ByteView{bytes}, 1U, 3U));
    claim((field_le<4U, 4U>(bytes)) == number_at(ByteView{bytes}, 4U, 4U));
    const std::uint64_t value = any<std::uint64_t>();
    set_field_le<2U, 2U>(bytes, value);
    for (std::size_t i = 0U; i < bytes.size(); ++i) {
        const bool inside = (i == 2U) || (i == 3U);
        claim(bytes[i] == (inside ? byte_of(value, i - 2U) : before[i]));
    }
}

void bit_patterns_survive_bit_cast() {
    shows("bit_cast() keeps every bit of a 32-bit pattern, there as a float and back");
    const auto bits = any<std::uint32_t>();
    claim(bit_cast<std::uint32_t>(bit_cast<float>(bits)) == bits);
}

}  // namespace canproof::proofs
