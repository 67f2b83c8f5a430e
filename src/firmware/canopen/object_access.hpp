// How SDO and PDO reach the object dictionary: through whoever guards it.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

/// The node implements this: type and limit checks, then the service that owns the entry, then the value, then its
/// effects.
class ObjectAccess {
  public:
    ObjectAccess(const ObjectAccess&) = delete;
    ObjectAccess& operator=(const ObjectAccess&) = delete;
    ObjectAccess(ObjectAccess&&) = delete;
    ObjectAccess& operator=(ObjectAccess&&) = delete;

    /// The value as it goes on the bus, or the abort code for an absent or write-only entry.
    virtual Result<ByteView, AbortCode> read(std::uint16_t index, std::uint8_t subindex) = 0;
    /// Writes all of `value` or nothing. AbortCode::none when done.
    virtual AbortCode write(std::uint16_t index, std::uint8_t subindex, ByteView value, Instant now) = 0;
    /// Capacity in bytes of an entry that may be written, or the reason why it may not.
    virtual Result<std::uint16_t, AbortCode> writable_size(std::uint16_t index, std::uint8_t subindex) = 0;

  protected:
    ObjectAccess() = default;
    ~ObjectAccess() = default;
};

}  // namespace canproof
