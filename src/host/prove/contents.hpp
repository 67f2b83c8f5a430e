// SPDX-License-Identifier: Apache-2.0
// The bytes of one object on one path of execution. Contents never change: each operation returns new ones.
#pragma once

#include <functional>
#include <memory>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

class Contents;
using ContentsPointer = std::shared_ptr<const Contents>;

/// The interface of all contents. Offsets have 64 bits and are in bounds: the caller has made that an obligation.
class Contents {
  public:
    Contents() = default;
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;
    virtual ~Contents() = default;

    /// Returns the `bytes` bytes from `offset` on as one word, the least significant byte first.
    virtual Term read(const Term& offset, unsigned bytes) const = 0;
    /// Returns these contents with the bytes of `word` from `offset` on.
    virtual ContentsPointer written(const Term& offset, const Term& word) const = 0;
    /// Returns these contents with `count` bytes from `offset` on replaced by those of `source` from `from` on.
    /// `source` may be these contents themselves.
    virtual ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from,
                                   const Term& count) const = 0;
    /// Returns these contents where the condition holds, and `otherwise` where it does not. Both belong to the same
    /// object.
    virtual ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const = 0;
};

/// Makes a new unknown value with `width` bits.
using MakeFresh = std::function<Term(unsigned width)>;

}  // namespace canproof::host::prove
