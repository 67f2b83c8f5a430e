// SPDX-License-Identifier: Apache-2.0
// Compares CRC-16 and CRC-32 of the firmware with the definition of a cyclic redundancy check, one bit at a time, for
// every state and every byte.
#include "firmware/base/crc16.hpp"
#include "firmware/base/crc32.hpp"
#include "properties/proofs/support/crc_by_definition.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

/// Returns a Crc16 with any state of 16 bits.
Crc16 any_crc16() {
    Crc16 crc{};
    crc.remainder_ = any<std::uint16_t>();
    return crc;
}

}  // namespace

void crc16_of_a_byte_is_as_defined() {
    shows("CRC-16 takes a byte as polynomial 1021h says, in every state");
    Crc16 crc = any_crc16();
    const std::uint16_t before = crc.value();
    const std::array<std::uint8_t, 1U> byte{any<std::uint8_t>()};
    crc.add(ByteView{byte});
    claim(crc.value() == crc16_by_definition(before, byte[0]));
    claim(crc.remainder_ <= 0xFFFFU);
}

void crc16_starts_with_zero() {
    shows("CRC-16 starts with zero and stays there for no bytes, in every state");
    claim(Crc16{}.value() == 0U);
    Crc16 crc = any_crc16();
    const std::uint16_t before = crc.value();
    crc.add(ByteView{});
    claim(crc.value() == before);
}

void crc16_of_a_segment_is_that_of_its_bytes() {
    shows("CRC-16 takes the seven bytes of a segment as one byte after the other, the least significant first");
    Crc16 crc = any_crc16();
    Crc16 each_byte = crc;
    const std::uint64_t frame = any<std::uint64_t>();
    for (std::uint32_t at = 8U; at < 64U; at += 8U) {
        const std::array<std::uint8_t, 1U> byte{static_cast<std::uint8_t>((frame >> at) & 0xFFU)};
        each_byte.add(ByteView{byte});
    }
    crc.add_segment(frame);
    claim(crc.value() == each_byte.value());
    claim(crc.remainder_ <= 0xFFFFU);
}

void crc16_of_bytes_is_that_of_each_byte() {
    shows("CRC-16 of up to 20 bytes is that of one byte after the other, in every state");
    constexpr std::size_t most = 20U;
    const auto bytes = any<std::array<std::uint8_t, most>>();
    const ByteView view = ByteView{bytes}.part(0U, each(most + 1U));
    Crc16 whole = any_crc16();
    Crc16 each_byte = whole;
    whole.add(view);
    for (std::size_t i = 0U; i < view.size(); ++i) {
        each_byte.add(view.part(i, 1U));
    }
    claim(whole.remainder_ == each_byte.remainder_);
}

void crc32_of_a_byte_is_as_defined() {
    shows("CRC-32 takes a byte as polynomial 04C11DB7h, mirrored, says, in every state");
    Crc32 crc{};
    crc.register_ = any<std::uint32_t>();
    const std::uint32_t before = crc.register_;
    const std::array<std::uint8_t, 1U> byte{any<std::uint8_t>()};
    crc.add(ByteView{byte});
    claim(crc.register_ == crc32_by_definition(before, byte[0]));
    claim(crc.value() == ~crc.register_);
}

void crc32_of_its_own_crc_is_the_residue() {
    shows("CRC-32 over any bytes and then their CRC is 2144DF1Ch, from every state");
    Crc32 crc{};
    crc.register_ = any<std::uint32_t>();
    std::array<std::uint8_t, 4U> own{};
    write_le(MutableBytes{own}, 0U, own.size(), crc.value());
    crc.add(ByteView{own});
    claim(crc.value() == Crc32::residue);
}

}  // namespace canproof::proofs
