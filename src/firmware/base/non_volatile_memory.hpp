// SPDX-License-Identifier: Apache-2.0
// The interface to an EEPROM or flash page: bytes that survive a power cut.
#pragma once

#include "firmware/base/bytes.hpp"

namespace canproof {

class NonVolatileMemory {
  public:
    NonVolatileMemory(const NonVolatileMemory&) = delete;
    NonVolatileMemory& operator=(const NonVolatileMemory&) = delete;
    NonVolatileMemory(NonVolatileMemory&&) = delete;
    NonVolatileMemory& operator=(NonVolatileMemory&&) = delete;

    virtual std::size_t size() const = 0;
    /// Fills `to` from address `at` on. Returns false when the memory fails or the range lies outside it.
    virtual bool read(std::size_t at, MutableBytes to) const = 0;
    /// Writes in ascending order of addresses. Returns false when the memory fails or the range lies outside it. After
    /// a failed write, as after a power cut, any number of the first bytes may have been written, even all of them.
    virtual bool write(std::size_t at, ByteView bytes) = 0;
    /// Makes all writes permanent: after it returns true, no power cut undoes them. Returns false when the memory
    /// fails; the memory then holds what the last successful commit() left.
    virtual bool commit() = 0;

  protected:
    NonVolatileMemory() = default;
    ~NonVolatileMemory() = default;
};

}  // namespace canproof
