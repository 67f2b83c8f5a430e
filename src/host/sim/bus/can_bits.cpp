// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/can_bits.hpp"

namespace canproof::host {

namespace {

constexpr unsigned base_id_bits = 11U;
constexpr unsigned extension_bits = 18U;
constexpr unsigned crc_bits = 15U;
constexpr std::uint16_t crc_polynomial = 0x4599U;
constexpr unsigned stuff_after = 5U;
constexpr std::uint64_t ns_per_s = 1000000000U;
/// Bits that are sent without stuff bits: CRC delimiter, acknowledge slot, acknowledge delimiter, seven bits end of
/// frame.
constexpr unsigned tail_bits = 1U + 1U + 1U + 7U;

void append(std::vector<bool>& bits, std::uint32_t value, unsigned count) {
    for (unsigned i = count; i > 0; --i) {
        bits.push_back(((value >> (i - 1U)) & 1U) != 0U);
    }
}

void append_identifier(std::vector<bool>& bits, const Frame& frame) {
    if (frame.extended) {
        append(bits, frame.id >> extension_bits, base_id_bits);
        append(bits, 0b11U, 2U);  // the recessive bits SRR and IDE
        append(bits, frame.id, extension_bits);
        append(bits, frame.remote ? 1U : 0U, 1U);
        append(bits, 0U, 2U);  // the bits r1 and r0
    } else {
        append(bits, frame.id, base_id_bits);
        append(bits, frame.remote ? 1U : 0U, 1U);
        append(bits, 0U, 2U);  // the bits IDE and r0
    }
}

}  // namespace

std::vector<bool> unstuffed_bits(const Frame& frame) {
    std::vector<bool> bits;
    bits.reserve(160);
    append(bits, 0U, 1U);  // the bit start of frame
    append_identifier(bits, frame);
    append(bits, frame.length, 4U);
    for (std::size_t i = 0; !frame.remote && i < frame.length; ++i) {
        append(bits, frame.data[i], 8U);
    }
    return bits;
}

std::uint16_t crc15(const std::vector<bool>& bits) {
    std::uint16_t crc = 0;
    for (const bool bit : bits) {
        const bool top = ((crc >> (crc_bits - 1U)) & 1U) != 0U;
        crc = static_cast<std::uint16_t>((std::uint32_t{crc} << 1U) & 0x7FFFU);
        crc = top != bit ? static_cast<std::uint16_t>(crc ^ crc_polynomial) : crc;
    }
    return crc;
}

unsigned count_stuff_bits(const std::vector<bool>& bits) {
    unsigned stuffed = 0;
    unsigned equal = 0;
    bool level = true;
    for (const bool bit : bits) {
        equal = bit == level ? equal + 1U : 1U;
        level = bit;
        if (equal == stuff_after) {
            ++stuffed;
            level = !level;
            equal = 1;
        }
    }
    return stuffed;
}

unsigned frame_bits(const Frame& frame) {
    std::vector<bool> bits = unstuffed_bits(frame);
    append(bits, crc15(bits), crc_bits);
    return static_cast<unsigned>(bits.size()) + count_stuff_bits(bits) + tail_bits;
}

std::uint64_t frame_time_ns(const Frame& frame, std::uint32_t bit_rate) {
    return (std::uint64_t{frame_bits(frame)} + intermission_bits) * ns_per_s / bit_rate;
}

std::uint32_t arbitration_rank(const Frame& frame) {
    const std::uint32_t remote = frame.remote ? 1U : 0U;
    if (!frame.extended) {
        return (frame.id << 21U) | (remote << 20U);
    }
    const std::uint32_t base = frame.id >> extension_bits;
    const std::uint32_t rest = frame.id & ((1U << extension_bits) - 1U);
    return (base << 21U) | (0b11U << 19U) | (rest << 1U) | remote;
}

}  // namespace canproof::host
