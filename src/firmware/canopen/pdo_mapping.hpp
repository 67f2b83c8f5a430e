// What the mapped bits of a PDO mean: packing and unpacking by object 16xxh or 1Axxh (CiA 301, 7.5.2.36 and 7.5.2.38).
#pragma once

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_access.hpp"

namespace canproof {

class PdoMapping {
  public:
    /// `index` is the mapping object; `right` is rights::rpdo or rights::tpdo.
    PdoMapping(const ObjectDictionary& objects, const std::uint16_t index, const std::uint8_t right) noexcept
        : objects_{objects}, index_{index}, right_{right} {}

    std::uint8_t count() const noexcept { return static_cast<std::uint8_t>(objects_.read(index_, 0U)); }
    /// Length in bytes of a PDO that carries all that is mapped, 0…8.
    std::uint8_t length() const noexcept;

    /// Whether one mapping entry may stand in this PDO: 06020000h or 06090011h when its object is absent, 06040041h
    /// when it may not be mapped, has another length, or is a dummy of unknown type. Zero (nothing mapped) is allowed.
    AbortCode check_entry(std::uint32_t entry) const noexcept;
    /// Whether the first `count` entries make a PDO: each of them sound, 64 bits in all at most (06040042h).
    AbortCode check_count(std::uint8_t count) const noexcept;

    /// Writes the mapped values: all of them, or none when one is outside its limits.
    void apply(const Frame& frame, ObjectAccess& access, Instant now) const noexcept;
    /// The mapped values as they go on the bus under `id`.
    Frame pack(std::uint32_t id) const noexcept;

  private:
    /// One line of the mapping object.
    struct Line {
        std::uint16_t index{0U};
        std::uint8_t subindex{0U};
        std::uint8_t bits{0U};
    };

    Line line(std::uint8_t subindex) const noexcept;
    bool fits(const Frame& frame) const noexcept;

    const ObjectDictionary& objects_;
    std::uint16_t index_;
    std::uint8_t right_;
};

}  // namespace canproof
