// SPDX-License-Identifier: Apache-2.0
// Theorems on numbers in memory, least significant byte first (CiA 301, 7.1.4), for memory of any size and any
// position.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/numbers_in_memory.hpp"

namespace canproof::proofs {

void positions_inside_have_32_bits() {
    shows(
        "of 1 to 8 bytes from a position inside of memory of any size, all lie in it, or it ends behind the first; "
        "the position and the number of bytes behind them have 32 bits");
    const std::size_t count = std::size_t{each(longest)} + 1U;
    const std::size_t size = any_size();
    const std::size_t at = any<std::size_t>();
    assume(at < size);
    const std::size_t left = size - at;
    const std::size_t there = (left < count) ? left : count;
    const std::size_t behind = left - there;
    claim((at <= UINT32_MAX) && (behind <= UINT32_MAX));
    claim((there >= 1U) && (there <= count));
    claim((there == count) || (behind == 0U));
    claim(size == (at + there + behind));
}

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
void put_le_puts_4_bytes() {
    shows("put_le<4>() puts 4 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<4U>();
}

void put_le_puts_5_to_7_bytes() {
    shows("put_le<5>() to put_le<7>() put their bytes as put_le<4>() does");
    switch (each(3U)) {
        case 0U:
            put_and_look<5U>();
            break;
        case 1U:
            put_and_look<6U>();
            break;
        default:
            put_and_look<7U>();
            break;
    }
}

void put_le_puts_8_bytes() {
    shows("put_le<8>() puts 8 bytes, the least significant first, drops what does not fit and changes nothing else");
    put_and_look<8U>();
}

void exchange_le_writes_another_number() {
    shows("exchange_le() puts a number of 0 to 8 bytes into its view, and says whether another number was there");
    const std::size_t count = each(longest + 1U);
    const Span span = (count == 0U) ? span_outside(count) : any_whole_span(count);
    const Other other = any_other(span);
    const std::uint64_t value = any<std::uint64_t>();
    assume((count == longest) || ((value >> (8U * count)) == 0U));
    const std::uint64_t before = span.number();
    claim(span.bytes().exchange_le(span.at, count, value) == (before != value));
    claim_put(span, other, value);
}

void get_le_reads_1_byte() {
    shows("get_le<1>() reads the byte at its position, and zero outside");
    get_and_compare<1U>();
}
void get_le_reads_2_bytes() {
    shows("get_le<2>() and read_u16() read 2 bytes, the least significant first; those outside are zero");
    const Span span = any_span(2U);
    claim(get_le<2U>(span.view(), span.at) == span.number());
    claim(read_u16(span.view(), span.at) == span.number());
}
void get_le_reads_4_bytes() {
    shows("get_le<4>() and read_u32() read 4 bytes, the least significant first; those outside are zero");
    const Span span = any_span(4U);
    claim(get_le<4U>(span.view(), span.at) == span.number());
    claim(read_u32(span.view(), span.at) == span.number());
}

void get_le_reads_3_to_7_bytes() {
    shows("get_le<3>() and get_le<5>() to get_le<7>() read their bytes as get_le<4>() does");
    switch (each(4U)) {
        case 0U:
            get_and_compare<3U>();
            break;
        case 1U:
            get_and_compare<5U>();
            break;
        case 2U:
            get_and_compare<6U>();
            break;
        default:
            get_and_compare<7U>();
            break;
    }
}

void get_le_reads_8_bytes() {
    shows("get_le<8>() reads 8 bytes, the least significant first; those outside are zero");
    get_and_compare<8U>();
}

void read_le_reads_what_is_there() {
    shows("read_le() and join_each() read 0 to 8 bytes, the least significant first; those outside are zero");
    const Span span = any_span(each(longest + 1U));
    const std::uint64_t number = span.number();
    claim(read_le(span.view(), span.at, span.count) == number);
    claim(join_each(span.view(), span.at, span.count) == number);
}

void the_number_in_a_view_is_its_bytes() {
    shows("number_in() reads a view of 0 to 8 bytes, the least significant first");
    const std::size_t size = each(longest + 1U);
    const Span span{any_memory(size), size, 0U, size, size};
    claim(number_in(span.view()) == span.number());
}

void fields_of_arrays_are_their_bytes() {
    shows("field_le() and set_field_le() reach the bytes of their field and no others");
    auto bytes = any<std::array<std::uint8_t, 8U>>();
    const std::array<std::uint8_t, 8U> before = bytes;
    claim((field_le<1U, 3U>(bytes)) ==
          (std::uint64_t{bytes[1]} | (std::uint64_t{bytes[2]} << 8U) | (std::uint64_t{bytes[3]} << 16U)));
    claim((field_le<4U, 4U>(bytes)) == ((std::uint64_t{bytes[4]} | (std::uint64_t{bytes[5]} << 8U)) |
                                        ((std::uint64_t{bytes[6]} << 16U) | (std::uint64_t{bytes[7]} << 24U))));
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
