// How SDO and PDO reach the object dictionary: through whoever guards it.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

/// Where a download of an entry may gather before it is written.
struct WritePlace {
    std::size_t capacity{0U};  ///< bytes that the entry takes at most
    MutableBytes staging{};    ///< memory lent for it; empty when the server shall use its own
};

/// The node implements this: type and limit checks, then the service that owns the entry, then the value, then its
/// effects.
class ObjectAccess {
  public:
    ObjectAccess(const ObjectAccess&) = delete;
    ObjectAccess& operator=(const ObjectAccess&) = delete;
    ObjectAccess(ObjectAccess&&) = delete;
    ObjectAccess& operator=(ObjectAccess&&) = delete;

    /// The value as it goes on the bus, or the abort code for an absent or write-only entry. Memory of a DOMAIN is
    /// lent: its bytes stay as they are until that entry is written or the node is reset.
    virtual Result<ByteView, AbortCode> read(std::uint16_t index, std::uint8_t subindex) = 0;
    /// Writes all of `value` or nothing. AbortCode::none when done. `value` may lie in the staging of writable().
    virtual AbortCode write(std::uint16_t index, std::uint8_t subindex, ByteView value, Instant now) = 0;
    /// Where the new value of an entry may gather, or the reason why it may not be written. What is staged there and
    /// never written has no effect.
    virtual Result<WritePlace, AbortCode> writable(std::uint16_t index, std::uint8_t subindex) = 0;
    /// Whether the owner of an entry takes the number that a PDO brought; type and limits are checked.
    virtual AbortCode before_received(const EntryRef& entry, std::uint64_t bits) = 0;
    /// A value was taken and stands in the dictionary; `changes`: another one stood there before. Its effects: in the
    /// service that owns it, and in the TPDOs that carry it.
    virtual void after_put(const EntryRef& entry, bool changes, Instant now) = 0;

  protected:
    ObjectAccess() = default;
    ~ObjectAccess() = default;
};

}  // namespace canproof
