// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/pdo_mapping.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t max_bits = 64U;
// The indices 0001h (BOOLEAN) … 0007h (UNSIGNED32) are data types. In a mapping they stand for gaps.
constexpr std::uint32_t last_dummy_index = 0x0007U;

constexpr bool is_dummy(const std::uint16_t index) noexcept {
    return index <= last_dummy_index;
}

/// Returns the length in bits of a dummy entry by data type 0…7; zero for 0, which is no data type.
constexpr std::uint8_t dummy_bits(const std::uint16_t type_index) noexcept {
    constexpr std::array<std::uint8_t, 8U> bits{0U, 1U, 8U, 16U, 32U, 8U, 16U, 32U};
    return bits[type_index];
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

/// Returns the number of bits that an entry occupies in a PDO: one for a BOOLEAN, whole bytes for all other types.
std::uint32_t bit_length(const EntryRow& row) noexcept {
    return (row.type == DataType::boolean) ? 1U : (row.size * 8U);
}

/// Returns `bits` (1…64) bits of a number from bit `at` on. Not inlined, because shifts of 64 bits take many
/// instructions on a 32-bit processor.
[[gnu::noinline]] std::uint64_t cut_out(const std::uint64_t number, const std::uint32_t at,
                                        const std::uint32_t bits) noexcept {
    return (number >> at) & (UINT64_MAX >> ((max_bits - bits) % max_bits));
}

}  // namespace

static_assert(implements<req::CO_PDO_010> && implements<req::CO_PDO_057>);
AbortCode check_mapping_entry(const ObjectDictionary& objects, const std::uint32_t right,
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
    const EntryRef found = objects.lookup(index, subindex_of(entry));
    if (!found.exists()) {
        return objects.missing(index);
    }
    const bool sound = found.may(right) && (bits != 0U) && (bits == bit_length(*found.row));
    return sound ? AbortCode::none : AbortCode::not_mappable;
}

static_assert(implements<req::CO_PDO_011>);
AbortCode check_mapping_count(const ObjectDictionary& objects, const std::uint32_t right, const std::uint16_t index,
                              const std::uint32_t count) noexcept {
    std::uint32_t bits{0U};
    for (std::uint32_t line = 1U; line <= count; ++line) {
        const std::uint8_t subindex = static_cast<std::uint8_t>(line);
        if (!objects.has(index, subindex)) {
            return AbortCode::mapping_too_long;
        }
        const std::uint32_t entry = objects.read(index, subindex);
        static_assert(implements<req::CO_PDO_064>);
        const AbortCode code = (entry == 0U) ? AbortCode::not_mappable : check_mapping_entry(objects, right, entry);
        if (code != AbortCode::none) {
            return code;
        }
        bits += bits_of(entry);
    }
    return (bits > max_bits) ? AbortCode::mapping_too_long : AbortCode::none;
}

namespace {

constexpr std::size_t nowhere = SIZE_MAX;

/// Returns where the bytes of a mapping line begin in the image of values. Returns `nowhere` for a constant, a gap, or
/// a value that is not mapped as 1, 2 or 4 whole bytes.
std::size_t offset_in_image(const PdoLine& line) noexcept {
    const bool lies_there = (line.width != 0U) && !line.row->may(rights::constant);
    return lies_there ? std::size_t{line.row->offset} : nowhere;
}

/// Returns the present value of the entry that a mapping line maps; zero for a gap.
inline std::uint64_t present_value(const PdoLine& line, const ObjectDictionary& objects) noexcept {
    switch (line.width) {
        case 1U:
            return load_le<1U>(line.value);
        case 2U:
            return load_le<2U>(line.value);
        case 4U:
            return load_le<4U>(line.value);
        default:
            return (line.row != nullptr) ? cut_out(objects.bits(*line.row), 0U, line.bits) : 0U;
    }
}

}  // namespace

PdoLine PdoMapping::find_line(const ObjectDictionary& objects, const std::uint32_t entry) noexcept {
    const EntryRef found = objects.lookup(index_of(entry), subindex_of(entry));
    PdoLine line{found.row, index_of(entry), bits_of(entry), 0U, nullptr};
    const ByteView bytes = found.exists() ? objects.bytes(*found.row) : ByteView{};
    const bool simple = (bytes.size() == 1U) || (bytes.size() == 2U) || (bytes.size() == 4U);
    if (simple && (line.bits == (bytes.size() * 8U))) {
        line.width = static_cast<std::uint8_t>(bytes.size());
        line.value = bytes.data();
    }
    return line;
}

void PdoMapping::resolve(const ObjectDictionary& objects, const std::uint16_t index,
                         const Slots<PdoLine>& places) noexcept {
    const std::uint32_t wanted = objects.read(index, 0U);
    std::uint32_t total{0U};
    std::size_t count{0U};
    all_free_ = true;
    marks_ = 0U;
    for (std::uint32_t number = 1U; (number <= wanted) && (count < places.size()); ++number) {
        const PdoLine line = find_line(objects, objects.read(index, static_cast<std::uint8_t>(number)));
        total += line.bits;
        if (line.bits != 0U) {
            places[count] = line;
            ++count;
            all_free_ = all_free_ && line.is_free();
            marks_ |= (line.row != nullptr) ? watch_mark(line.index, line.row->subindex) : 0U;
        }
    }
    // A mapping too long for a frame cannot be written (check_mapping_count). If the defaults contain one, it is not
    // used.
    const bool fits = (wanted <= max_pdo_lines) && (total <= max_bits);
    lines_ = places.part(0U, fits ? count : 0U);
    length_ = static_cast<std::uint8_t>(fits ? ((total + 7U) / 8U) : 0U);
    mapped_ = is_usable() ? cut_out(UINT64_MAX, 0U, total) : 0U;
    run_ = find_run(objects);
}

/// Returns where the mapped values begin in the image, if they are adjacent there in the order of the lines. Returns
/// nullptr when they are not, or when eight bytes cannot be read there.
const std::uint8_t* PdoMapping::find_run(const ObjectDictionary& objects) const noexcept {
    const std::size_t first = is_usable() ? offset_in_image(*lines_.begin()) : nowhere;
    std::size_t next{first};
    bool is_run{first != nowhere};
    for (const PdoLine& line : lines_) {
        is_run = is_run && (offset_in_image(line) == next);
        next += line.width;
    }
    const ByteView run = objects.image().part(first, max_frame_length);
    return (is_run && (run.size() == max_frame_length)) ? run.data() : nullptr;
}

static_assert(implements<req::CO_PDO_005>);
bool PdoMapping::is_acceptable(const std::uint64_t packed, const ObjectDictionary& objects,
                               ObjectAccess& access) const noexcept {
    std::uint32_t at{0U};
    for (const PdoLine& line : lines_) {
        static_assert(implements<req::CO_PDO_012>);
        if (!line.is_free()) {
            const std::uint64_t value = cut_out(packed, at, line.bits);
            AbortCode code = objects.check_bits(*line.row, value);
            if (code == AbortCode::none) {
                code = access.before_received(line.entry(), value);
            }
            if (code != AbortCode::none) {
                return false;
            }
        }
        at += line.bits;
    }
    return true;
}

void PdoMapping::apply_lines(const std::uint64_t packed, ObjectDictionary& objects, ObjectAccess& access,
                             const Instant now) const noexcept {
    std::uint32_t at{0U};
    for (const PdoLine& line : lines_) {
        if (line.row != nullptr) {
            const std::uint64_t value = cut_out(packed, at, line.bits);
            const bool changes = (value != present_value(line, objects)) ? objects.put_bits(*line.row, value) : false;
            if (changes || (line.row->service != Service::none)) {
                access.after_put(line.entry(), changes, now);
            }
        }
        at += line.bits;
    }
}

/// Writes all values, which lie at run_ and have neither limits nor an owner, with one access of eight bytes. The bytes
/// behind the values keep their contents.
void PdoMapping::put_run(const std::uint64_t packed, ObjectDictionary& objects) const noexcept {
    const std::uint64_t behind = load_le<max_frame_length>(run_) & ~mapped_;
    objects.image().put_le<max_frame_length>(lines_.begin()->row->offset, behind | (packed & mapped_));
}

static_assert(implements<req::CO_PDO_028>);
std::uint64_t PdoMapping::collect(const ObjectDictionary& objects) const noexcept {
    std::uint64_t packed{0U};
    std::uint32_t at{0U};
    for (const PdoLine& line : lines_) {
        packed |= present_value(line, objects) << at;
        at += line.bits;
    }
    return packed;
}

}  // namespace canproof
