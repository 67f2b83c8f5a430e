// SPDX-License-Identifier: Apache-2.0
// A record of the accesses of a driver to the registers of a model, for tests of exact values and of their order.
#pragma once

#include <algorithm>
#include <utility>

#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

/// The accesses to one or more blocks of registers, in their order.
class RegisterRecord {
  public:
    struct Access {
        bool is_write;
        std::size_t offset;  ///< of the register in its block, in bytes, plus the base of the block
        std::uint32_t bits;
    };

    void note(const Access& access) { all_.push_back(access); }
    void clear() { all_.clear(); }

    /// Returns offset and bits of each write.
    std::vector<std::pair<std::size_t, std::uint32_t>> writes() const {
        std::vector<std::pair<std::size_t, std::uint32_t>> found;
        for (const Access& access : all_) {
            if (access.is_write) {
                found.emplace_back(access.offset, access.bits);
            }
        }
        return found;
    }
    /// Returns what was written to one register.
    std::vector<std::uint32_t> writes_to(std::size_t offset) const {
        std::vector<std::uint32_t> found;
        for (const auto& [at, bits] : writes()) {
            if (at == offset) {
                found.push_back(bits);
            }
        }
        return found;
    }
    /// Returns how often a register was read.
    std::size_t reads_of(std::size_t offset) const {
        const auto is_read = [offset](const Access& one) { return !one.is_write && one.offset == offset; };
        return static_cast<std::size_t>(std::count_if(all_.begin(), all_.end(), is_read));
    }
    /// Returns the number of all accesses.
    std::size_t size() const { return all_.size(); }

  private:
    std::vector<Access> all_;
};

/// Registers that pass each access on to those of a model, and record it.
template <typename Registers>
class RecordedRegisters final : public Peripheral {
  public:
    RecordedRegisters(Registers& model, RegisterRecord& record, std::size_t base = 0)
        : Peripheral{&block_, sizeof block_},
          model_{reinterpret_cast<stm32f405::Register*>(&model)},
          record_{record},
          base_{base} {}

    Registers& registers() { return block_; }

  private:
    std::uint32_t on_read(std::size_t offset) override {
        const std::uint32_t bits = model_[offset / 4].read();
        record_.note({false, base_ + offset, bits});
        return bits;
    }
    void on_write(std::size_t offset, std::uint32_t bits) override {
        record_.note({true, base_ + offset, bits});
        model_[offset / 4].write(bits);
    }

    Registers block_{};
    stm32f405::Register* model_;
    RegisterRecord& record_;
    std::size_t base_;
};

}  // namespace canproof::test
