#include "firmware/canopen/pdo_mapping.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t max_bits = 64U;
constexpr std::uint16_t last_dummy_index = 0x0007U;  // data types 0001h BOOLEAN … 0007h UNSIGNED32 stand for gaps

/// Length of a dummy entry by data type 1…7; zero for a type that cannot be one.
constexpr std::uint8_t dummy_bits(const std::uint16_t type_index) noexcept {
    constexpr std::array<std::uint8_t, 8U> bits{0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U};
    return (type_index <= last_dummy_index) ? bits[type_index] : std::uint8_t{0U};
}

constexpr bool is_dummy(const std::uint16_t index) noexcept {
    return index <= last_dummy_index;
}

/// Bits that an entry takes in a PDO: a BOOLEAN one, everything else whole bytes.
std::uint32_t bit_length(const EntryRow& row) noexcept {
    return (row.type == DataType::boolean) ? 1U : (row.size * 8U);
}

/// `bits` (1…64) bits from bit `at` of eight bytes, counted from the least significant bit of the first.
std::uint64_t extract(const std::uint64_t packed, const std::uint32_t at, const std::uint32_t bits) noexcept {
    const std::uint64_t mask = (bits >= max_bits) ? UINT64_MAX : ((std::uint64_t{1U} << bits) - 1U);
    return (at >= max_bits) ? 0U : ((packed >> at) & mask);
}

}  // namespace

PdoMapping::Line PdoMapping::line(const std::uint8_t subindex) const noexcept {
    const std::uint32_t entry = objects_.read(index_, subindex);
    return Line{static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>((entry >> 8U) & 0xFFU),
                static_cast<std::uint8_t>(entry & 0xFFU)};
}

std::uint8_t PdoMapping::length() const noexcept {
    std::uint32_t bits{0U};
    for (std::uint8_t sub = 1U; sub <= count(); ++sub) {
        bits += line(sub).bits;
    }
    return static_cast<std::uint8_t>((bits + 7U) / 8U);
}

AbortCode PdoMapping::check_entry(const std::uint32_t entry) const noexcept {
    const auto index = static_cast<std::uint16_t>(entry >> 16U);
    const auto subindex = static_cast<std::uint8_t>((entry >> 8U) & 0xFFU);
    const std::uint32_t bits = entry & 0xFFU;
    if (entry == 0U) {
        return AbortCode::none;
    }
    if (is_dummy(index)) {
        const bool sound = (right_ == rights::rpdo) && (subindex == 0U) && (bits != 0U) && (bits == dummy_bits(index));
        return sound ? AbortCode::none : AbortCode::not_mappable;
    }
    const auto found = objects_.find(index, subindex);
    if (!found.ok()) {
        return found.error();
    }
    const bool sound = found.value().may(right_) && (bits == bit_length(*found.value().row));
    return sound ? AbortCode::none : AbortCode::not_mappable;
}

AbortCode PdoMapping::check_count(const std::uint8_t count) const noexcept {
    std::uint32_t bits{0U};
    for (std::uint8_t sub = 1U; sub <= count; ++sub) {
        const std::uint32_t entry = objects_.read(index_, sub);
        const AbortCode code = (entry == 0U) ? AbortCode::not_mappable : check_entry(entry);
        if (code != AbortCode::none) {
            return code;
        }
        bits += entry & 0xFFU;
    }
    return (bits > max_bits) ? AbortCode::mapping_too_long : AbortCode::none;
}

bool PdoMapping::fits(const Frame& frame) const noexcept {
    const std::uint64_t packed = read_le(frame.payload(), 0U, max_frame_length);
    std::uint32_t at{0U};
    bool all{true};
    for (std::uint8_t sub = 1U; sub <= count(); ++sub) {
        const Line mapped = line(sub);
        std::array<std::uint8_t, 8U> bytes{};
        write_le(MutableBytes{bytes}, 0U, bytes.size(), extract(packed, at, mapped.bits));
        const auto found = objects_.find(mapped.index, mapped.subindex);
        if (found.ok()) {
            const ByteView value{bytes.data(), found.value().row->size};
            all = all && (objects_.check_value(found.value(), value) == AbortCode::none);
        }
        at += mapped.bits;
    }
    return all;
}

void PdoMapping::apply(const Frame& frame, ObjectAccess& access, const Instant now) const noexcept {
    if (!fits(frame)) {
        return;
    }
    const std::uint64_t packed = read_le(frame.payload(), 0U, max_frame_length);
    std::uint32_t at{0U};
    for (std::uint8_t sub = 1U; sub <= count(); ++sub) {
        const Line mapped = line(sub);
        if (!is_dummy(mapped.index)) {
            std::array<std::uint8_t, 8U> bytes{};
            write_le(MutableBytes{bytes}, 0U, bytes.size(), extract(packed, at, mapped.bits));
            const std::size_t size = (mapped.bits + std::size_t{7U}) / 8U;
            static_cast<void>(access.write(mapped.index, mapped.subindex, ByteView{bytes.data(), size}, now));
        }
        at += mapped.bits;
    }
}

Frame PdoMapping::pack(const std::uint32_t id) const noexcept {
    std::uint64_t packed{0U};
    std::uint32_t at{0U};
    for (std::uint8_t sub = 1U; sub <= count(); ++sub) {
        const Line mapped = line(sub);
        const auto found = objects_.find(mapped.index, mapped.subindex);
        if (found.ok() && (at < max_bits)) {
            const ByteView value = objects_.value(found.value());
            packed |= extract(read_le(value, 0U, value.size()), 0U, mapped.bits) << at;
        }
        at += mapped.bits;
    }
    Frame frame = data_frame(id, length());
    write_le(MutableBytes{frame.data}, 0U, max_frame_length, packed);
    return frame;
}

}  // namespace canproof
