// SPDX-License-Identifier: Apache-2.0
// Parameter memory in two sectors of flash. Its bytes lie in RAM; commit() appends the changed lines to a journal in
// one sector, and starts the other sector when the first is full. After a power cut at any word, the memory has the
// contents of the last commit().
//
// A sector has a header and slots of six words. The header is valid once its last word is right; of two valid sectors
// the one with the newer generation is used. A slot has a line of 16 bytes, the number of the line, the number of the
// commit and a CRC. The lines of a commit are valid once its last slot is complete.
#pragma once

#include "firmware/base/non_volatile_memory.hpp"
#include "firmware/base/slots.hpp"
#include "target/stm32f405/flash.hpp"

namespace canproof::stm32f405 {

/// A sector of flash: the number by which it is erased, and its words.
struct FlashSector {
    std::uint32_t number{0U};
    Slots<Register> words{};
};

class ParameterJournal final : public NonVolatileMemory {
  public:
    static constexpr std::size_t line_size = 16U;
    static constexpr std::size_t sector_count = 2U;

    /// `bytes`: the RAM copy of the memory, a multiple of 16 and at most 10 KiB; `changed`: one bit per line. Both must
    /// outlive the journal.
    ParameterJournal(Flash& flash, const std::array<FlashSector, sector_count>& sectors, const MutableBytes bytes,
                     const Slots<std::uint32_t> changed) noexcept
        : NonVolatileMemory{}, flash_{flash}, sectors_{sectors}, bytes_{bytes}, changed_{changed} {}

    /// Restores the last commit; call after power-on, before the first read.
    void open() noexcept;
    /// Erases the unused sector if necessary, which takes up to half a second, so that the next commit() that starts
    /// this sector need not erase it. Returns false when the flash fails.
    bool prepare() noexcept;
    /// Returns how many sectors were started so far; each of the two sectors was erased about half as often.
    std::uint32_t generation() const noexcept { return generation_; }

    std::size_t size() const override { return bytes_.size(); }
    bool read(std::size_t at, MutableBytes to) const override;
    bool write(std::size_t at, ByteView bytes) override;
    bool commit() override;

  private:
    static constexpr std::size_t slot_words = 6U;
    static constexpr std::size_t no_sector = sector_count;
    using Slot = std::array<std::uint32_t, slot_words>;

    Slots<Register> slot_at(std::size_t sector, std::size_t slot) const noexcept;
    std::size_t slots_of(std::size_t sector) const noexcept { return sectors_[sector].words.size() / slot_words; }
    std::size_t line_count() const noexcept { return bytes_.size() / line_size; }
    std::size_t spare() const noexcept { return (active_ == 0U) ? 1U : 0U; }

    bool is_in_use(std::size_t sector, std::uint32_t& generation) const noexcept;
    bool is_erased(std::size_t sector) const noexcept;
    bool is_blank(std::size_t sector, std::size_t slot) const noexcept;
    bool read_slot(std::size_t slot, Slot& content) const noexcept;
    void replay() noexcept;
    void apply(std::size_t from, std::size_t last, std::uint32_t number) noexcept;

    bool erase(std::size_t sector) noexcept;
    bool append() noexcept;
    bool move() noexcept;
    bool write_lines(std::size_t sector, std::size_t lines) noexcept;
    bool write_slot(std::size_t sector, std::size_t line, bool is_last) noexcept;
    bool write_words(const Slots<Register>& words, const Slot& content, std::size_t from, std::size_t last) noexcept;

    bool has_changed(const std::size_t line) const noexcept { return (changed_[line / 32U] & bit_of(line)) != 0U; }
    void set_changed(std::size_t line, bool changed) noexcept;
    std::size_t changed_count() const noexcept;
    void note_filled_lines() noexcept;
    static constexpr std::uint32_t bit_of(const std::size_t line) noexcept {
        return bit(static_cast<std::uint32_t>(line % 32U));
    }

    Flash& flash_;
    std::array<FlashSector, sector_count> sectors_;
    MutableBytes bytes_;
    Slots<std::uint32_t> changed_;
    std::size_t active_{no_sector};
    std::size_t next_slot_{1U};
    std::uint32_t generation_{0U};
    std::uint32_t number_{0U};  ///< number of the last commit, complete or not
};

/// The RAM that the journal of a memory of `Size` bytes needs.
template <std::size_t Size>
struct JournalRam {
    static_assert(((Size % ParameterJournal::line_size) == 0U) && (Size <= 10240U), "a sector holds every line once");

    std::array<std::uint8_t, Size> bytes{};
    std::array<std::uint32_t, ((Size / ParameterJournal::line_size) + 31U) / 32U> changed{};
};

}  // namespace canproof::stm32f405
