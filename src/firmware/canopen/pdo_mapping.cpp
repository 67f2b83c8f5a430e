#include "firmware/canopen/pdo_mapping.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t max_bits = 64U;
constexpr std::uint32_t last_dummy_index = 0x0007U;  // data types 0001h BOOLEAN … 0007h UNSIGNED32 stand for gaps

/// Length of a dummy entry by data type 1…7; zero for a type that cannot be one.
constexpr std::uint8_t dummy_bits(const std::uint16_t type_index) noexcept {
    constexpr std::array<std::uint8_t, 8U> bits{0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U};
    return (type_index <= last_dummy_index) ? bits[type_index] : std::uint8_t{0U};
}

constexpr bool is_dummy(const std::uint16_t index) noexcept {
    return index <= last_dummy_index;
}

constexpr std::uint16_t index_of(const std::uint32_t entry) noexcept {
    return static_cast<std::uint16_t>(entry >> 16U);
}
constexpr std::uint8_t subindex_of(const std::uint32_t entry) noexcept {
    return static_cast<std::uint8_t>((entry >> 8U) & 0xFFU);
}
constexpr std::uint8_t bits_of(const std::uint32_t entry) noexcept {
    return static_cast<std::uint8_t>(entry & 0xFFU);
}

/// Bits that an entry takes in a PDO: a BOOLEAN one, everything else whole bytes.
std::uint32_t bit_length(const EntryRow& row) noexcept {
    return (row.type == DataType::boolean) ? 1U : (row.size * 8U);
}

/// `bits` (0…64) bits from bit `at` (0…63) of eight bytes, counted from the least significant bit of the first.
constexpr std::uint64_t extract(const std::uint64_t packed, const std::uint32_t at, const std::uint32_t bits) noexcept {
    const std::uint64_t mask = (bits >= max_bits) ? UINT64_MAX : ((std::uint64_t{1U} << bits) - 1U);
    return (at < max_bits) ? ((packed >> at) & mask) : 0U;
}

/// The value moved up to bit `at`: nothing is left of it from bit 64 on.
constexpr std::uint64_t placed(const std::uint64_t value, const std::uint32_t at) noexcept {
    return (at < max_bits) ? (value << at) : 0U;
}

std::uint64_t packed_of(const Frame& frame) noexcept {
    return read_le(ByteView{frame.data}, 0U, max_frame_length);
}

using ValueBytes = std::array<std::uint8_t, max_frame_length>;

/// The first bytes of `scratch`, made to hold a value of `bits` bits.
ByteView as_bytes(const std::uint64_t value, const std::uint32_t bits, ValueBytes& scratch) noexcept {
    write_le(MutableBytes{scratch}, 0U, scratch.size(), value);
    return ByteView{scratch.data(), (bits + std::size_t{7U}) / 8U};
}

}  // namespace

static_assert(implements<req::CO_PDO_010> && implements<req::CO_PDO_012>);
AbortCode check_mapping_entry(const ObjectDictionary& objects, const std::uint8_t right,
                              const std::uint32_t entry) noexcept {
    const std::uint16_t index = index_of(entry);
    const std::uint32_t bits = bits_of(entry);
    if (entry == 0U) {
        return AbortCode::none;
    }
    if (is_dummy(index)) {
        const bool sound =
            (right == rights::rpdo) && (subindex_of(entry) == 0U) && (bits != 0U) && (bits == dummy_bits(index));
        return sound ? AbortCode::none : AbortCode::not_mappable;
    }
    const auto found = objects.find(index, subindex_of(entry));
    if (!found.ok()) {
        return found.error();
    }
    const bool sound = found.value().may(right) && (bits != 0U) && (bits == bit_length(*found.value().row));
    return sound ? AbortCode::none : AbortCode::not_mappable;
}

static_assert(implements<req::CO_PDO_011>);
AbortCode check_mapping_count(const ObjectDictionary& objects, const std::uint8_t right, const std::uint16_t index,
                              const std::uint8_t count) noexcept {
    std::uint32_t bits{0U};
    for (std::uint32_t line = 1U; line <= count; ++line) {
        const std::uint8_t subindex = static_cast<std::uint8_t>(line);
        if ((line > PdoMapping::max_lines) || !objects.has(index, subindex)) {
            return AbortCode::mapping_too_long;
        }
        const std::uint32_t entry = objects.read(index, subindex);
        const AbortCode code = (entry == 0U) ? AbortCode::not_mappable : check_mapping_entry(objects, right, entry);
        if (code != AbortCode::none) {
            return code;
        }
        bits += bits_of(entry);
    }
    return (bits > max_bits) ? AbortCode::mapping_too_long : AbortCode::none;
}

PdoMapping::Line PdoMapping::find_line(const ObjectDictionary& objects, const std::uint32_t entry,
                                       const std::uint32_t at) noexcept {
    const auto found = objects.find(index_of(entry), subindex_of(entry));
    Line line{nullptr, index_of(entry), bits_of(entry), false, false};
    if (found.ok()) {
        const EntryRow& row = *found.value().row;
        line.row = &row;
        line.bytes = ((at % 8U) == 0U) && (line.bits == (row.size * 8U)) && (row.type != DataType::boolean) &&
                     ((row.rights & rights::constant) == 0U);
        line.plain = line.bytes && (row.limit == no_limit) && (row.service == Service::none) &&
                     ((row.rights & rights::tpdo) == 0U);
    }
    return line;
}

void PdoMapping::append(const Line& line) noexcept {
    Line* const last = (count_ == 0U) ? nullptr : &lines_[count_ - 1U];
    const bool joins =
        (last != nullptr) && last->plain && line.plain && (line.row->offset == (last->row->offset + (last->bits / 8U)));
    if (joins) {
        last->bits = static_cast<std::uint8_t>(std::uint32_t{last->bits} + line.bits);
    } else if (count_ < lines_.count) {
        lines_[count_] = line;
        ++count_;
    } else {
        // no such entry: it reads as zero, which maps nothing
    }
}

void PdoMapping::resolve(const ObjectDictionary& objects, const std::uint16_t index) noexcept {
    const std::uint32_t wanted = objects.read(index, 0U);
    std::uint32_t total{0U};
    count_ = 0U;
    all_plain_ = true;
    for (std::uint32_t number = 1U; (number <= wanted) && (number <= max_lines) && (total <= max_bits); ++number) {
        const std::uint32_t entry = objects.read(index, static_cast<std::uint8_t>(number));
        const Line line = find_line(objects, entry, total);
        total += line.bits;
        if ((line.bits != 0U) && (total <= max_bits)) {
            append(line);
            all_plain_ = all_plain_ && (line.plain || (line.row == nullptr));
        }
    }
    // A mapping that no frame can carry cannot be written (check_mapping_count); one that was shipped so is not used.
    if ((wanted > max_lines) || (total > max_bits)) {
        count_ = 0U;
        total = 0U;
    }
    length_ = static_cast<std::uint8_t>((total + 7U) / 8U);
}

bool PdoMapping::maps(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
    bool found{false};
    for (std::size_t i = 0U; i < count_; ++i) {
        const Line& line = lines_[i];
        found = found || ((line.row != nullptr) && EntryRef{line.row, line.index}.is(index, subindex));
    }
    return found;
}

std::uint64_t PdoMapping::watch_marks() const noexcept {
    std::uint64_t marks{0U};
    for (std::size_t i = 0U; i < count_; ++i) {
        const Line& line = lines_[i];
        marks |= (line.row != nullptr) ? watch_mark(line.index, line.row->subindex) : 0U;
    }
    return marks;
}

bool PdoMapping::is_acceptable(const std::uint64_t packed, const ObjectDictionary& objects,
                               ObjectAccess& access) const noexcept {
    std::uint32_t at{0U};
    for (std::size_t i = 0U; i < count_; ++i) {
        const Line& line = lines_[i];
        if ((line.row != nullptr) && !line.plain) {
            ValueBytes scratch{};
            const EntryRef entry{line.row, line.index};
            const ByteView value = as_bytes(extract(packed, at, line.bits), line.bits, scratch);
            if (objects.check_value(entry, value) != AbortCode::none) {
                return false;
            }
            if (access.before_received(entry, value) != AbortCode::none) {
                return false;
            }
        }
        at += line.bits;
    }
    return true;
}

static_assert(implements<req::CO_PDO_005>);
void PdoMapping::apply(const Frame& frame, ObjectDictionary& objects, ObjectAccess& access,
                       const Instant now) const noexcept {
    if (!all_plain_ && !is_acceptable(packed_of(frame), objects, access)) {
        return;
    }
    std::uint32_t at{0U};
    for (std::size_t i = 0U; i < count_; ++i) {
        const Line& line = lines_[i];
        if (line.plain) {
            objects.image().copy(line.row->offset, ByteView{frame.data}.part(at / 8U, line.bits / 8U));
        } else if (line.row != nullptr) {
            ValueBytes scratch{};
            const ByteView value = as_bytes(extract(packed_of(frame), at, line.bits), line.bits, scratch);
            access.put_received(EntryRef{line.row, line.index}, value, now);
        } else {
            // a gap
        }
        at += line.bits;
    }
}

static_assert(implements<req::CO_PDO_028>);
Frame PdoMapping::pack(const ObjectDictionary& objects, const std::uint32_t id) const noexcept {
    Frame frame = data_frame(id, length_);
    MutableBytes data{frame.data};
    std::uint64_t packed{0U};
    std::uint32_t at{0U};
    for (std::size_t i = 0U; i < count_; ++i) {
        const Line& line = lines_[i];
        if (line.bytes) {
            data.copy(at / 8U, objects.image().part(line.row->offset, line.bits / 8U));
        } else if (line.row != nullptr) {
            packed |= placed(extract(objects.bits(EntryRef{line.row, line.index}), 0U, line.bits), at);
        } else {
            // a gap
        }
        at += line.bits;
    }
    for (std::size_t i = 0U; (packed != 0U) && (i < max_frame_length); ++i) {
        data.set(i, static_cast<std::uint8_t>(data[i] | (packed & 0xFFU)));
        packed >>= 8U;
    }
    return frame;
}

}  // namespace canproof
