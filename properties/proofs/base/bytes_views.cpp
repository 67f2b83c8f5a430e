// SPDX-License-Identifier: Apache-2.0
// Proves that views of bytes never read or write outside of their bytes, for memory of any size and for any position
// and number of bytes.
#include "firmware/base/bytes.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

void part_lies_in_its_view() {
    shows("a part of a view begins where it is asked to, ends with the view, and is as long as asked where it fits");
    const std::size_t size = any_size();
    const ByteView view{any_memory(size), size};
    const std::size_t from = any<std::size_t>();
    const std::size_t count = any<std::size_t>();
    const ByteView part = view.part(from, count);
    const std::size_t start = (from < size) ? from : size;
    claim(part.data() == (view.data() + start));
    claim(part.size() <= (size - start));
    claim((part.size() == count) || ((part.size() < count) && (part.size() == (size - start))));
}

void part_of_writable_bytes_lies_in_them() {
    shows("a part of writable bytes is the same bytes as a part of their view");
    const std::size_t size = any_size();
    const MutableBytes bytes{any_memory(size), size};
    const std::size_t from = any<std::size_t>();
    const std::size_t count = any<std::size_t>();
    const ByteView part = bytes.part(from, count).view();
    const ByteView same = bytes.view().part(from, count);
    claim(part.data() == same.data());
    claim(part.size() == same.size());
}

void reading_past_the_end_gives_zero() {
    shows("a view reads the byte of its memory at each position, and zero at all others");
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t at = any<std::size_t>();
    const std::uint8_t read = ByteView{memory, size}[at];
    claim((at < size) ? (read == memory[at]) : (read == 0U));
    claim((MutableBytes{memory, size}[at]) == read);
}

void an_empty_view_reads_zero() {
    shows("a view without memory is empty, reads zero everywhere and has only empty parts");
    const std::size_t at = any<std::size_t>();
    const ByteView nothing{};
    claim(nothing.empty());
    claim(nothing.size() == 0U);
    claim(nothing[at] == 0U);
    claim(nothing.part(at, any<std::size_t>()).empty());
    MutableBytes none{};
    none.set(at, any<std::uint8_t>());
    none.copy(at, nothing);
    claim(none[at] == 0U);
    claim(none.size() == 0U);
}

void setting_a_byte_changes_that_alone() {
    shows("set() writes the byte at its position and no other; outside it writes nothing");
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t at = any<std::size_t>();
    const std::size_t looked_at = any<std::size_t>();
    assume(looked_at < size);
    const std::uint8_t before = memory[looked_at];
    const std::uint8_t value = any<std::uint8_t>();
    MutableBytes{memory, size}.set(at, value);
    claim(memory[looked_at] == ((looked_at == at) ? value : before));
}

void copying_drops_what_does_not_fit() {
    shows("copy() moves the source to its position, byte by byte, drops what does not fit and changes nothing else");
    const std::size_t size = any_size();
    std::uint8_t* const memory = any_memory(size);
    const std::size_t length = any_size();
    const std::uint8_t* const source = any_memory(length);
    const std::size_t at = any<std::size_t>();
    const std::size_t looked_at = any<std::uint32_t>();  // the memory has at most 2^32 bytes
    assume(looked_at < size);
    const std::uint8_t before = memory[looked_at];
    MutableBytes{memory, size}.copy(at, ByteView{source, length});
    const bool copied = (looked_at >= at) && ((looked_at - at) < length);
    claim(memory[looked_at] == (copied ? source[looked_at - at] : before));
}

void a_view_of_an_array_is_all_of_it() {
    shows("a view of an array begins with it and has its size");
    std::array<std::uint8_t, 5U> bytes{};
    claim(ByteView{bytes}.data() == bytes.data());
    claim(ByteView{bytes}.size() == 5U);
    claim(MutableBytes{bytes}.view().data() == bytes.data());
    claim(MutableBytes{bytes}.size() == 5U);
}

}  // namespace canproof::proofs
