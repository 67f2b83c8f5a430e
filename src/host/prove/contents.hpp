// The bytes of one object, as they are on a path. Contents never change: each operation makes new ones.
#pragma once

#include <functional>
#include <memory>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

class Contents;
using ContentsPointer = std::shared_ptr<const Contents>;

/// Offsets are 64 bits and in bounds: the caller has made that an obligation.
class Contents {
  public:
    Contents() = default;
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;
    virtual ~Contents() = default;

    /// `bytes` bytes from there as one word, the least significant first.
    virtual Term read(const Term& offset, unsigned bytes) const = 0;
    /// With the bytes of a word from there on.
    virtual ContentsPointer written(const Term& offset, const Term& word) const = 0;
    /// With `count` bytes of `source` from `from` on; `source` may be these contents themselves.
    virtual ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from,
                                   const Term& count) const = 0;
    /// These where the condition holds, the others elsewhere: of the same object.
    virtual ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const = 0;
};

/// Makes a new unknown of a width.
using MakeFresh = std::function<Term(unsigned width)>;

}  // namespace canproof::host::prove
