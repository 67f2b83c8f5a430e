// SPDX-License-Identifier: Apache-2.0
// The contents of memory whose size may be unknown: a bottom layer of unknown bytes, and a further layer for each
// operation.
#pragma once

#include <functional>

#include "host/prove/contents.hpp"

namespace canproof::host::prove {

class LayeredContents : public Contents, public std::enable_shared_from_this<LayeredContents> {
  public:
    Term read(const Term& offset, unsigned bytes, const Reach& reach) const override;
    ContentsPointer written(const Term& offset, const Term& word, const Reach& reach) const override;
    ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from, const Term& count,
                           const Reach& reach) const override;
    ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const override;

    /// Returns the byte at an offset.
    virtual Term at(const Term& offset) const = 0;
};

/// One byte of unknown memory that was read: its offset and its value.
struct AskedByte {
    Term offset;
    Term value;
};

/// The bottom layer, in which the byte at each offset is unknown. Calls `know` for each byte that is read, so that the
/// solver gives equal bytes to equal offsets.
class UnknownBytes : public LayeredContents {
  public:
    using Know = std::function<void(const void* memory, const Term& offset, const Term& value)>;
    UnknownBytes(MakeFresh fresh, Know know) : fresh_{std::move(fresh)}, know_{std::move(know)} {}
    Term at(const Term& offset) const override;
    const std::vector<AskedByte>& asked() const { return asked_; }

  private:
    MakeFresh fresh_;
    Know know_;
    mutable std::vector<AskedByte> asked_;  ///< bytes that were read so far; a read at another offset adds one
};

}  // namespace canproof::host::prove
