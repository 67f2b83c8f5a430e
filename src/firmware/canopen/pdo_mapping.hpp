// SPDX-License-Identifier: Apache-2.0
// The mapping of a PDO: packs and unpacks its values by object 16xxh or 1Axxh (CiA 301, 7.5.2.36 and 7.5.2.38). A
// mapping is resolved when it changes, so that a frame needs no search in the dictionary.
#pragma once

#include "firmware/base/slots.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_access.hpp"

namespace canproof {

/// Checks one mapping entry for a PDO of this direction (`right`: rights::rpdo or rights::tpdo). Returns 06020000h when
/// its object is absent and 06090011h when only its sub-index is. Returns 06040041h when the object may not be mapped
/// in this direction or has another length. Returns the same code for a dummy (index 0000h to 0007h) that is in a TPDO,
/// has a sub-index, or has not the length of its type. Returns AbortCode::none for a correct entry and for zero
/// (nothing mapped).
AbortCode check_mapping_entry(const ObjectDictionary& objects, std::uint32_t right, std::uint32_t entry) noexcept;

/// Checks whether the first `count` entries of mapping object `index` are a valid mapping. Returns the code of
/// check_mapping_entry() for the first wrong entry, and 06040041h for an entry that is zero. Returns 06040042h when the
/// object has fewer entries, or when the entries have more than 64 bits together. Returns AbortCode::none otherwise.
AbortCode check_mapping_count(const ObjectDictionary& objects, std::uint32_t right, std::uint16_t index,
                              std::uint32_t count) noexcept;

/// Most mapping entries of a PDO: 64 entries of one bit fill it (CiA 301, 7.5.2.36).
constexpr std::size_t max_pdo_lines = 64U;

/// One line of a mapping object with the entry that it maps.
struct PdoLine {
    const EntryRow* row{nullptr};  ///< nullptr: a gap (dummy entry)
    std::uint16_t index{0U};
    std::uint8_t bits{0U};
    std::uint8_t width{0U};  ///< 1, 2 or 4: exactly this number of bytes at `value` are mapped; 0: another width
    const std::uint8_t* value{nullptr};

    EntryRef entry() const noexcept { return EntryRef{row, index}; }
    /// Returns whether a frame may write any value of this line without a check: the entry has no limits and no owner,
    /// or the line is a gap.
    bool is_free() const noexcept {
        return (row == nullptr) || ((row->limit == no_limit) && (row->service == Service::none));
    }
};

/// A mapping object whose entries have been looked up in the dictionary.
class PdoMapping {
  public:
    /// Reads mapping object `index` again and stores its lines in `places`.
    void resolve(const ObjectDictionary& objects, std::uint16_t index, const Slots<PdoLine>& places) noexcept;

    /// Returns false when nothing is mapped, or more than a frame can carry.
    bool is_usable() const noexcept { return !lines_.empty(); }
    /// Returns the length in bytes of a PDO with all mapped values, 0…8.
    std::uint8_t length() const noexcept { return length_; }
    bool maps(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
        for (const PdoLine& line : lines_) {
            if ((line.row != nullptr) && line.entry().is(index, subindex)) {
                return true;
            }
        }
        return false;
    }
    /// Returns a set of bits that contains watch_mark() of each mapped value. A value whose bit is not in the set is
    /// not mapped here.
    std::uint64_t watch_marks() const noexcept { return marks_; }

    /// Returns whether each mapped value is within its limits and its owner accepts it. `frame` has at least length()
    /// bytes.
    bool accepts(const Frame& frame, const ObjectDictionary& objects, ObjectAccess& access) const noexcept {
        if (all_free_) {
            return true;
        }
        return is_acceptable(packed_values(frame), objects, access);
    }
    /// Writes the mapped values of an accepted frame.
    void apply(const Frame& frame, ObjectDictionary& objects, ObjectAccess& access, const Instant now) const noexcept {
        const std::uint64_t packed = packed_values(frame);
        if (!all_free_ || (run_ == nullptr)) {
            apply_lines(packed, objects, access, now);
        } else if (((packed ^ load_le<max_frame_length>(run_)) & mapped_) == 0U) {
            // all values stay as they are
        } else if (access.is_watched(marks_)) {
            apply_lines(packed, objects, access, now);
        } else {
            put_run(packed, objects);
        }
    }
    /// Returns the mapped values as sent on the bus, first byte in the lowest bits.
    std::uint64_t values(const ObjectDictionary& objects) const noexcept {
        return (run_ != nullptr) ? (load_le<max_frame_length>(run_) & mapped_) : collect(objects);
    }

  private:
    static std::uint64_t packed_values(const Frame& frame) noexcept {
        return field_le<0U, max_frame_length>(frame.data);
    }
    static PdoLine find_line(const ObjectDictionary& objects, std::uint32_t entry) noexcept;
    const std::uint8_t* find_run(const ObjectDictionary& objects) const noexcept;
    bool is_acceptable(std::uint64_t packed, const ObjectDictionary& objects, ObjectAccess& access) const noexcept;
    void apply_lines(std::uint64_t packed, ObjectDictionary& objects, ObjectAccess& access, Instant now) const noexcept;
    void put_run(std::uint64_t packed, ObjectDictionary& objects) const noexcept;
    std::uint64_t collect(const ObjectDictionary& objects) const noexcept;

    std::uint8_t length_{0U};
    bool all_free_{false};
    /// Address at which all values are adjacent in frame order and eight bytes can be read; nullptr when there is none.
    const std::uint8_t* run_{nullptr};
    Slots<PdoLine> lines_{};
    std::uint64_t mapped_{0U};  ///< the bits of a frame that a line covers, gaps included
    std::uint64_t marks_{0U};   ///< see watch_marks()
};

/// Returns the bit that represents an entry in a 64-bit set. Two entries may share a bit.
constexpr std::uint64_t watch_mark(const std::uint32_t index, const std::uint32_t subindex) noexcept {
    const std::uint32_t spread = index + (index >> 4U) + subindex;
    return std::uint64_t{1U} << (spread & 63U);
}

}  // namespace canproof
