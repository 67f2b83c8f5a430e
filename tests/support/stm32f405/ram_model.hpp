// SPDX-License-Identifier: Apache-2.0
// A model of RAM with one faulty cell (the victim), which may depend on another cell (the aggressor): the usual fault
// models of memory tests.
#pragma once

#include "firmware/base/slots.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

/// One bit of one word of the RAM.
struct Cell {
    std::size_t word;
    std::uint32_t bit;
};

class RamModel final : public Peripheral {
  public:
    enum class Fault {
        none,
        stuck,       ///< the victim always is `value`
        transition,  ///< the victim cannot change to `value`
        address,     ///< a write to the aggressor's word reaches the victim's word too
        inversion,   ///< the victim is inverted when the aggressor changes to `edge`
        idempotent,  ///< the victim becomes `value` when the aggressor changes to `edge`
        state        ///< the victim is `value` while the aggressor is `edge`
    };
    struct Defect {
        Fault fault{Fault::none};
        Cell victim{0, 0};
        bool value{false};
        Cell aggressor{0, 0};
        bool edge{false};
    };

    explicit RamModel(std::size_t words) : RamModel{std::vector<stm32f405::Register>(words)} {}

    Slots<stm32f405::Register> words() { return {block_.data(), block_.size()}; }
    /// Returns a word as it is stored. The access does not trigger the defect.
    std::uint32_t& at(std::size_t word) { return content_.at(word); }
    /// Returns the number of accesses; unmasked() returns the number of accesses with interrupts enabled.
    std::size_t accesses() const { return accesses_; }
    std::size_t unmasked() const { return unmasked_; }

    /// Gives the RAM a defect; it begins behind the access number `from`.
    void set_defect(const Defect& defect, std::size_t from = 0) {
        defect_ = defect;
        defect_from_ = from;
    }

  private:
    explicit RamModel(std::vector<stm32f405::Register> block)
        : Peripheral{block.data(), block.size() * 4}, block_{std::move(block)}, content_(block_.size()) {}
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;
    bool is_set(const Cell& cell) const { return (content_[cell.word] >> cell.bit & 1U) != 0; }
    void set(const Cell& cell, bool value);
    Fault fault_now() const { return accesses_ > defect_from_ ? defect_.fault : Fault::none; }
    void note_access();

    std::vector<stm32f405::Register> block_;
    std::vector<std::uint32_t> content_;
    Defect defect_{};
    std::size_t accesses_{0}, unmasked_{0}, defect_from_{0};
};

}  // namespace canproof::test
