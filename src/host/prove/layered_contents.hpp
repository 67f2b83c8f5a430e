// Contents of memory of any size: unknown bytes at the bottom, each operation a layer above them.
#pragma once

#include <functional>

#include "host/prove/contents.hpp"

namespace canproof::host::prove {

class LayeredContents : public Contents, public std::enable_shared_from_this<LayeredContents> {
  public:
    Term read(const Term& offset, unsigned bytes) const override;
    ContentsPointer written(const Term& offset, const Term& word) const override;
    ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from,
                           const Term& count) const override;
    ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const override;

    /// The byte there.
    virtual Term at(const Term& offset) const = 0;
};

/// One byte of unknown memory that was asked for.
struct AskedByte {
    Term offset;
    Term value;
};

/// The bottom: each offset has an unknown byte, equal offsets the same one. `know` takes that as a fact.
class UnknownBytes : public LayeredContents {
  public:
    UnknownBytes(MakeFresh fresh, std::function<void(const Term&)> know)
        : fresh_{std::move(fresh)}, know_{std::move(know)} {}
    Term at(const Term& offset) const override;
    const std::vector<AskedByte>& asked() const { return asked_; }

  private:
    MakeFresh fresh_;
    std::function<void(const Term&)> know_;
    mutable std::vector<AskedByte> asked_;  ///< what is unknown until somebody looks
};

}  // namespace canproof::host::prove
