// SPDX-License-Identifier: Apache-2.0
// The bytes of one object on one path of execution. A contents object never changes: each operation returns a new one.
#pragma once

#include <functional>
#include <memory>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

class Contents;

/// The bytes of an object that an access may reach: those from `first` to `end` - 1.
struct Reach {
    std::uint64_t first{0};
    std::uint64_t end{UINT64_MAX};
};
using ContentsPointer = std::shared_ptr<const Contents>;

/// The interface of all kinds of contents of an object. Offsets have 64 bits. They are in bounds, because the caller
/// adds the obligation that they are.
class Contents {
  public:
    Contents() = default;
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;
    virtual ~Contents() = default;

    /// Returns the `bytes` bytes from `offset` on as one word, the least significant byte first.
    virtual Term read(const Term& offset, unsigned bytes, const Reach& reach = {}) const = 0;
    /// Returns contents in which the bytes of `word` replace those from `offset` on.
    virtual ContentsPointer written(const Term& offset, const Term& word, const Reach& reach = {}) const = 0;
    /// Returns contents in which the bytes of `source` from `from` on replace `count` bytes from `offset` on. `source`
    /// may be this object.
    virtual ContentsPointer copied(const Term& offset, const ContentsPointer& source, const Term& from,
                                   const Term& count, const Reach& reach = {}) const = 0;
    /// Returns contents that equal these contents where the condition is true, and `otherwise` where it is false.
    /// `otherwise` must belong to the same object.
    virtual ContentsPointer merged(const Term& condition, const ContentsPointer& otherwise) const = 0;
};

/// A function that makes a new unknown value with `width` bits.
using MakeFresh = std::function<Term(unsigned width)>;

}  // namespace canproof::host::prove
