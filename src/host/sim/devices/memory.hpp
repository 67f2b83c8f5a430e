// SPDX-License-Identifier: Apache-2.0
// A simulated EEPROM. It can outlive the device object, and its power can fail during a write.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "firmware/base/non_volatile_memory.hpp"

namespace canproof::host {

class Memory final : public NonVolatileMemory {
  public:
    explicit Memory(std::size_t size) : bytes_(size, 0xFF) {}

    std::size_t size() const override { return bytes_.size(); }
    bool read(std::size_t at, MutableBytes to) const override;
    bool write(std::size_t at, ByteView bytes) override;
    bool commit() override;

    /// A function that stores the memory's content at a commit. It returns false when it cannot store the content.
    using Keeper = std::function<bool(const std::vector<std::uint8_t>&)>;
    /// Sets the function that stores the content. The present content counts as stored. Without such a function, every
    /// commit succeeds.
    void keep_by(Keeper keeper) {
        keeper_ = std::move(keeper);
        kept_ = bytes_;
    }

    /// Makes the power fail after `count` more bytes. Further writes have no effect.
    void cut_power_after(std::size_t count) { bytes_left_ = count; }
    void restore_power() { bytes_left_ = std::numeric_limits<std::size_t>::max(); }
    /// Returns the number of bytes written since the construction. The power can fail before each of them.
    std::size_t written() const { return written_; }

    std::vector<std::uint8_t>& bytes() { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
    Keeper keeper_;
    std::vector<std::uint8_t> kept_;  ///< content of the last commit; used only with a keeper
    std::size_t bytes_left_{std::numeric_limits<std::size_t>::max()};
    std::size_t written_{0};
};

}  // namespace canproof::host
