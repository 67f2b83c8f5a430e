// SPDX-License-Identifier: Apache-2.0
// The accesses of drivers to the registers of a model, by the offsets of the reference manual.
#pragma once

#include <optional>
#include <utility>

#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

/// Records the accesses to one or more blocks of registers, in their order.
class RegisterRecord {
  public:
    using One = std::pair<std::size_t, std::uint32_t>;  ///< offset of the register, and bits
    using Writes = std::vector<One>;

    /// Records the accesses to `block` too. `base` is added to the offset of each of its registers.
    template <typename Registers>
    void watch(const Registers& block, std::size_t base = 0) {
        blocks_.push_back({reinterpret_cast<std::uintptr_t>(&block), sizeof block, base});
    }
    void clear() {
        log_.emplace();
        writes_.clear();
    }

    const Writes& writes() {
        for (const Write& one : log_->take_writes()) {
            for (const Block& block : blocks_) {
                if (one.address >= block.address && one.address - block.address < block.size) {
                    writes_.emplace_back(one.address - block.address + block.base, one.bits);
                }
            }
        }
        return writes_;
    }
    /// Returns what was written to one register.
    std::vector<std::uint32_t> writes_to(std::size_t offset) {
        std::vector<std::uint32_t> found;
        for (const auto& [at, bits] : writes()) {
            if (at == offset) {
                found.push_back(bits);
            }
        }
        return found;
    }
    /// Returns how often a register of the first block was read.
    std::size_t reads_of(std::size_t offset) const { return log_->reads_of(blocks_.at(0).address + offset); }
    /// Returns the number of all reads of registers of the first block.
    std::size_t reads() const {
        std::size_t count = 0;
        for (std::size_t offset = 0; offset < blocks_.at(0).size; offset += 4) {
            count += reads_of(offset);
        }
        return count;
    }

  private:
    struct Block {
        std::uintptr_t address;
        std::size_t size, base;
    };

    std::optional<AccessLog> log_{std::in_place};
    std::vector<Block> blocks_;
    Writes writes_;
};

}  // namespace canproof::test
