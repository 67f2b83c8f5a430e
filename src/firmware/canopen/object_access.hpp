// SPDX-License-Identifier: Apache-2.0
// The interface through which SDO and PDO access the object dictionary: the node checks every access.
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"

namespace canproof {

/// The memory that collects a download of an entry before the write.
struct WritePlace {
    std::size_t capacity{0U};  ///< most bytes that the entry can hold
    MutableBytes staging{};    ///< memory of the device for the download; empty when the server shall use its own
};

/// The node implements this interface. A write is checked first against type and limits, then by the service that owns
/// the entry. After that the value is stored and takes effect.
class ObjectAccess {
  public:
    ObjectAccess(const ObjectAccess&) = delete;
    ObjectAccess& operator=(const ObjectAccess&) = delete;
    ObjectAccess(ObjectAccess&&) = delete;
    ObjectAccess& operator=(ObjectAccess&&) = delete;

    /// Returns the value as sent on the bus, or an abort code when the entry cannot be read, for example because it is
    /// absent or write-only. For a DOMAIN entry the bytes stay unchanged until that entry is written or the node is
    /// reset.
    virtual Result<ByteView, AbortCode> read(std::uint16_t index, std::uint8_t subindex) = 0;
    /// Writes all of `value` or nothing. Returns AbortCode::none on success. `value` may lie in the staging memory that
    /// writable() returned.
    virtual AbortCode write(std::uint16_t index, std::uint8_t subindex, ByteView value, Instant now) = 0;
    /// Returns the memory for the new value of an entry, or the reason why the entry cannot be written. Staged bytes
    /// have no effect until they are written.
    virtual Result<WritePlace, AbortCode> writable(std::uint16_t index, std::uint8_t subindex) = 0;
    /// Returns AbortCode::none when the owner of an entry accepts a number received by PDO, otherwise the reason. Type
    /// and limits have been checked before.
    virtual AbortCode before_received(const EntryRef& entry, std::uint64_t bits) = 0;
    /// Applies the effects of a new value that is already in the dictionary: in the service that owns the entry and in
    /// the TPDOs that carry the value. `changes`: the new value differs from the old one.
    virtual void after_put(const EntryRef& entry, bool changes, Instant now) = 0;
    /// Returns false when no TPDO waits for a change of the values whose watch_mark() is in `marks`. after_put() then
    /// has no effect for a value of them that no service owns.
    virtual bool is_watched(std::uint64_t marks) const = 0;

  protected:
    ObjectAccess() = default;
    ~ObjectAccess() = default;
};

}  // namespace canproof
