// A simulated EEPROM: survives the device object, can lose power in the middle of a write.
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

    /// Where a commit takes the content; false when it cannot be kept there.
    using Keeper = std::function<bool(const std::vector<std::uint8_t>&)>;
    /// What is there now counts as kept. Without a keeper every commit succeeds.
    void keep_by(Keeper keeper) {
        keeper_ = std::move(keeper);
        kept_ = bytes_;
    }

    /// Power fails after `count` more bytes: what is written after that is lost.
    void cut_power_after(std::size_t count) { bytes_left_ = count; }
    void restore_power() { bytes_left_ = std::numeric_limits<std::size_t>::max(); }
    /// Bytes written since the start: how many places there are to cut at.
    std::size_t written() const { return written_; }

    std::vector<std::uint8_t>& bytes() { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
    Keeper keeper_;
    std::vector<std::uint8_t> kept_;  ///< with a keeper
    std::size_t bytes_left_{std::numeric_limits<std::size_t>::max()};
    std::size_t written_{0};
};

}  // namespace canproof::host
