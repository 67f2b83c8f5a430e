// Numbers in memory, least significant byte first (CiA 301, 7.1.4), for memory of any size and any position.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

constexpr std::size_t longest = 8U;

/// Byte `at` of a number.
std::uint8_t byte_of(const std::uint64_t number, const std::size_t at) {
    return static_cast<std::uint8_t>((number >> (8U * at)) & 0xFFU);
}

/// What memory holds there: a byte of the number where it was put, and what it held before elsewhere.
struct Looked {
    std::uint8_t* memory;
    std::size_t size;
    std::size_t at;
    std::uint8_t before;
};

Looked look() {
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t at = any<std::size_t>();
    assume(at < size);
    return {memory, size, at, memory[at]};
}

void claim_put(const Looked& looked, const std::size_t at, const std::size_t count, const std::uint64_t value) {
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

/// The number that bytes from a position make; those beyond the view count as zero.
std::uint64_t number_at(const ByteView bytes, const std::size_t at, const std::size_t count) {
    std::uint64_t number{0U};
    for (std::size_t i = 0U; i < longest; ++i) {
        const bool there = (i < count) && (at < bytes.size()) && (i < (bytes.size() - at));
        number |= there ? (std::uint64_t{bytes[at + i]} << (8U * i)) : 0U;
    }
    return number;
}

struct Read {
    ByteView view;
    std::size_t at;
};

Read any_read() {
    const std::size_t size = any_size();
    return {ByteView{any_memory(size), size}, any<std::size_t>()};
}

}  // namespace

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
