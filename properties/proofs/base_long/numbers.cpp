// SPDX-License-Identifier: Apache-2.0
// Theorems on longer numbers in memory, and on numbers of any length, least significant byte first. Each takes several
// seconds.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/numbers_in_memory.hpp"

namespace canproof::proofs {

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

void set_le_puts_what_fits() {
    shows("set_le() and write_le() put 0 to 8 bytes, the least significant first, and change nothing else");
    const Span span = any_span(each(longest + 1U));
    const Other other = any_other(span);
    const std::uint64_t value = any<std::uint64_t>();
    write_le(span.bytes(), span.at, span.count, value);
    claim_put(span, other, value);
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

}  // namespace canproof::proofs
