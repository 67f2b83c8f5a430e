// What the mapped bits of a PDO mean: packing and unpacking by object 16xxh or 1Axxh (CiA 301, 7.5.2.36 and 7.5.2.38).
// A mapping is resolved when it changes, so that a frame costs no search in the dictionary.
#pragma once

#include <array>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/pdo_communication.hpp"

namespace canproof {

/// Whether one mapping entry may stand in a PDO of this direction (rights::rpdo or rights::tpdo): 06020000h or
/// 06090011h when its object is absent, 06040041h when it may not be mapped, has another length, or is a dummy of
/// unknown type. Zero (nothing mapped) is allowed.
AbortCode check_mapping_entry(const ObjectDictionary& objects, std::uint8_t right, std::uint32_t entry) noexcept;

/// Whether the first `count` entries of mapping object `index` make a PDO: each of them sound and none empty, no more
/// than the object has and 64 bits in all at most (06040042h).
AbortCode check_mapping_count(const ObjectDictionary& objects, std::uint8_t right, std::uint16_t index,
                              std::uint8_t count) noexcept;

/// One resolved mapping object.
class PdoMapping {
  public:
    /// CiA 301, 7.5.2.36: 64 entries of one bit each fill a PDO.
    static constexpr std::size_t max_lines = 64U;

    /// One line of the mapping object, its entry found.
    struct Line {
        const EntryRow* row{nullptr};  ///< nullptr: a gap
        std::uint16_t index{0U};
        std::uint8_t bits{0U};
        bool bytes{false};  ///< just the bits / 8 bytes of the image from the row's offset, on a byte boundary
        bool plain{false};  ///< such bytes without limits, owner or anyone to be told; neighbours are joined into one
    };

    /// Takes memory for as many lines as the mapping object has entries; fewer, and the lines behind are not mapped.
    void lend(const MutableTable<Line> lines) noexcept { lines_ = lines; }
    /// Reads mapping object `index` anew.
    void resolve(const ObjectDictionary& objects, std::uint16_t index) noexcept;

    /// False when nothing is mapped, or more than a frame can carry.
    bool is_usable() const noexcept { return count_ != 0U; }
    /// Length in bytes of a PDO that carries all that is mapped, 0…8.
    std::uint8_t length() const noexcept { return length_; }
    bool maps(std::uint16_t index, std::uint8_t subindex) const noexcept;
    /// One bit for each mapped value, by watch_mark(): what cannot be mapped here is seen at once.
    std::uint64_t watch_marks() const noexcept;

    /// Writes the mapped values: all of them, or none when one is outside its limits or refused by its owner. `frame`
    /// is at least length() bytes long.
    void apply(const Frame& frame, ObjectDictionary& objects, ObjectAccess& access, Instant now) const noexcept;
    /// The mapped values as they go on the bus under `id`.
    Frame pack(const ObjectDictionary& objects, std::uint32_t id) const noexcept;

  private:
    static Line find_line(const ObjectDictionary& objects, std::uint32_t entry, std::uint32_t at) noexcept;
    void append(const Line& line) noexcept;
    bool is_acceptable(std::uint64_t packed, const ObjectDictionary& objects, ObjectAccess& access) const noexcept;

    MutableTable<Line> lines_{};
    std::uint8_t count_{0U};
    std::uint8_t length_{0U};
    bool all_plain_{false};
};

/// Entries of mapping object `index`, no more than a PDO can have; zero without such an object.
constexpr std::size_t count_mapping_lines(const DictionaryTables& tables, const std::uint16_t index) noexcept {
    std::size_t count{0U};
    for (const ObjectRow& object : tables.objects) {
        if (std::uint32_t{object.index} == index) {
            count = tables.entries[(object.first_entry + std::size_t{object.count}) - 1U].subindex;
        }
    }
    return (count < PdoMapping::max_lines) ? count : PdoMapping::max_lines;
}

/// The same of all PDOs of a direction together.
constexpr std::size_t count_mapping_lines(const DictionaryTables& tables, const PdoDirection direction) noexcept {
    std::size_t count{0U};
    for (std::size_t number = 0U; number < count_pdos(tables, direction); ++number) {
        count += count_mapping_lines(tables, mapping_object(direction, number));
    }
    return count;
}

/// Lends each PDO of a direction its part of `lines`, in their order. `Pdo` has a member `mapping`.
template <typename Pdo>
void lend_lines(const MutableTable<Pdo> pdos, const MutableTable<PdoMapping::Line> lines,
                const DictionaryTables& tables, const PdoDirection direction) noexcept {
    std::size_t used{0U};
    for (std::size_t number = 0U; number < pdos.count; ++number) {
        const std::size_t wanted = count_mapping_lines(tables, mapping_object(direction, number));
        const std::size_t rest = lines.count - used;
        const std::size_t given = (wanted < rest) ? wanted : rest;
        pdos[number].mapping.lend(MutableTable<PdoMapping::Line>{lines.rows + used, given});
        used += given;
    }
}

/// The bit of a 64-bit set that stands for an entry. Two entries may share one.
constexpr std::uint64_t watch_mark(const std::uint32_t index, const std::uint32_t subindex) noexcept {
    const std::uint32_t spread = index + (index >> 4U) + subindex;
    return std::uint64_t{1U} << (spread & 63U);
}

}  // namespace canproof
