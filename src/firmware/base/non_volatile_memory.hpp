// The port to an EEPROM or flash page: plain bytes that outlive a power cut.
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
    /// Reads all of `to` from address `at`. False when the memory failed or the range lies outside it.
    virtual bool read(std::size_t at, MutableBytes to) const = 0;
    /// Writes in ascending order of addresses; a power cut may leave any first part written. False when the memory
    /// failed.
    virtual bool write(std::size_t at, ByteView bytes) = 0;
    /// Makes what was written permanent: when it returns true, no power cut undoes it. False when the memory failed; it
    /// then has what the last successful commit() left.
    virtual bool commit() = 0;

  protected:
    NonVolatileMemory() = default;
    ~NonVolatileMemory() = default;
};

}  // namespace canproof
