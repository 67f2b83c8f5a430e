// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/pdo_frames.hpp"

namespace canproof::test::zoo {

namespace {

struct Line {
    EntryRef entry;
    unsigned bits{0};
};

std::vector<Line> lines_of(WrongSlave& slave, std::uint16_t mapping) {
    std::vector<Line> lines;
    const std::uint32_t count = slave.dictionary().read(mapping, 0);
    for (std::uint32_t sub = 1; sub <= count; ++sub) {
        const std::uint32_t mapped = slave.dictionary().read(mapping, static_cast<std::uint8_t>(sub));
        const auto index = static_cast<std::uint16_t>(mapped >> 16U);
        lines.push_back({slave.dictionary().lookup(index, static_cast<std::uint8_t>(mapped >> 8U)), mapped & 0xFFU});
    }
    return lines;
}

std::uint16_t object_of(std::uint16_t first, unsigned number) {
    return static_cast<std::uint16_t>(first + number);
}

std::uint64_t low_bits(std::uint64_t value, unsigned bits) {
    return bits >= 64 ? value : value & ((std::uint64_t{1} << bits) - 1);
}

}  // namespace

std::uint32_t pdo_parameter(WrongSlave& slave, std::uint16_t communication, unsigned number, std::uint8_t sub) {
    return slave.dictionary().read(object_of(communication, number), sub);
}

bool is_valid_pdo(WrongSlave& slave, std::uint16_t communication, unsigned number) {
    return (pdo_parameter(slave, communication, number, 1) & 0x80000000U) == 0;
}

std::optional<unsigned> pdo_of(WrongSlave& slave, std::uint16_t communication, const Frame& frame, bool valid) {
    for (unsigned number = 0; number < pdo_count && !frame.extended; ++number) {
        const bool has_id = (pdo_parameter(slave, communication, number, 1) & 0x7FFU) == frame.id;
        if (has_id && is_valid_pdo(slave, communication, number) == valid) {
            return number;
        }
    }
    return std::nullopt;
}

Frame tpdo_frame(WrongSlave& slave, unsigned number, Packing packing) {
    std::vector<Line> lines = lines_of(slave, object_of(tpdo_communication + mapping_offset, number));
    if (packing == Packing::reversed) {
        lines = {lines.rbegin(), lines.rend()};
    }
    std::uint64_t packed = 0;
    unsigned at = 0;
    for (const Line& line : lines) {
        const std::uint64_t value = line.entry.exists() ? slave.dictionary().bits(*line.entry.row) : 0;
        packed |= at < 64 ? low_bits(value, line.bits) << at : 0;
        at += packing == Packing::bytewise ? (line.bits + 7) / 8 * 8 : line.bits;
    }
    Frame frame = data_frame(pdo_parameter(slave, tpdo_communication, number, 1) & 0x7FFU, 0);
    set_field_le<0, 8>(frame.data, packed);
    return with_length(frame, at > 64 ? 8 : (at + 7) / 8);
}

void apply_rpdo(WrongSlave& slave, unsigned number, const Frame& frame) {
    const std::uint64_t packed = field_le<0, 8>(frame.data);
    unsigned at = 0;
    for (const Line& line : lines_of(slave, object_of(rpdo_communication + mapping_offset, number))) {
        if (line.entry.exists() && at + line.bits <= 64) {
            static_cast<void>(slave.dictionary().put_bits(*line.entry.row, low_bits(packed >> at, line.bits)));
        }
        at += line.bits;
    }
}

std::size_t rpdo_length(WrongSlave& slave, unsigned number) {
    std::size_t bits = 0;
    for (const Line& line : lines_of(slave, object_of(rpdo_communication + mapping_offset, number))) {
        bits += line.bits;
    }
    return (bits + 7) / 8;
}

}  // namespace canproof::test::zoo
