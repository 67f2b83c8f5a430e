// SPDX-License-Identifier: Apache-2.0
// Models of the flash controller and two sectors for their driver (RM0090 chapter 3). They model the unlock sequence,
// busy times, errors, bits that only an erase sets to 1, worn bits, and a power cut during a programming or an erase.
#pragma once

#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <utility>

#include "target/stm32f405/flash.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "tests/support/stm32f405/peripheral.hpp"

namespace canproof::test {

class FlashModel;

/// The words of one sector.
class SectorModel final : public Peripheral {
  public:
    SectorModel(FlashModel& controller, std::uint32_t number, std::size_t words);

    stm32f405::FlashSector sector() {
        return {number_, {reinterpret_cast<stm32f405::Register*>(cells_.data()), cells_.size()}};
    }
    std::vector<std::uint32_t>& cells() { return cells_; }
    std::uint32_t number() const { return number_; }
    void forget_cached();
    /// Changes a cell, except the bits that are worn out. The data cache, if it has read the cell, keeps the old
    /// content.
    void change(std::size_t word, std::uint32_t bits);
    /// Wears bits of a word out: from its next change on, the bits `high` are 1 and the bits `low` are 0.
    void wear(std::size_t word, std::uint32_t high, std::uint32_t low) { worn_[word] = {high, low}; }
    bool is_worn() const { return !worn_.empty(); }

  private:
    friend class FlashModel;

    SectorModel(FlashModel& controller, std::uint32_t number, std::vector<std::uint32_t> cells);
    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;

    FlashModel& controller_;
    std::uint32_t number_;
    std::vector<std::uint32_t> cells_;  ///< the registers of the driver are at the same place
    std::vector<bool> is_cached_;
    std::map<std::size_t, std::uint32_t> stale_;  ///< the cached content of cells that have changed since
    std::map<std::size_t, std::pair<std::uint32_t, std::uint32_t>> worn_;
};

class FlashModel final : public Peripheral {
  public:
    static constexpr std::size_t words_a_sector = 4096;                ///< 16 KiB
    static constexpr std::uint32_t write_protection_error = 1U << 4U;  ///< WRPERR of FLASH_SR

    explicit FlashModel(std::uint32_t seed = 1, std::size_t words = words_a_sector);

    stm32f405::FlashRegisters& registers() { return block_; }
    std::array<stm32f405::FlashSector, 2> sectors() { return {first_.sector(), second_.sector()}; }
    SectorModel& sector(std::size_t which) { return which == 0 ? first_ : second_; }

    /// Cuts the power during the `count`-th program or erase operation after this call; 0 cuts it at once. Later
    /// operations have no effect.
    void cut_power_after(std::size_t count) { operations_left_ = count; }
    bool has_power() const { return operations_left_ != 0; }
    /// Restores the power. The flash controller is then in the state after a reset, and no longer hangs.
    void restore_power();
    /// Makes one operation fail with the flag `error` of FLASH_SR: the one that follows `count` more operations. It
    /// has its effect all the same if `has_effect`.
    void fail_after(std::size_t count, std::uint32_t error = write_protection_error, bool has_effect = false) {
        fail_each_after(count, {has_effect}, error);
    }
    /// As fail_after(), but makes one operation fail for each element of `programs`. A failing operation whose element
    /// is true has its effect all the same.
    void fail_each_after(std::size_t count, std::deque<bool> programs, std::uint32_t error = write_protection_error) {
        until_failure_ = count;
        failing_programs_ = std::move(programs);
        failure_ = error;
    }
    /// Sets flags of FLASH_SR that no operation has caused.
    void raise(std::uint32_t flags) { status_ |= flags; }
    /// Makes each later operation busy until FLASH_SR was read `reads` times.
    void be_busy_for(std::uint32_t reads) { reads_an_operation_ = reads; }
    void end_operation() { busy_reads_ = 0; }
    bool is_busy() const { return busy_reads_ > 0 || stays_busy_; }
    void stay_busy(bool stays) {
        stays_busy_ = stays;
        hangs_ = false;
    }
    /// Makes the controller busy from the next operation on, until stay_busy(false).
    void hang_in_next_operation() { hangs_ = true; }
    /// Returns the number of operations so far (a programmed word or an erased sector is one operation). erases()
    /// returns how often one sector was erased.
    std::size_t operations() const { return operations_; }
    std::size_t erases(std::size_t which) const { return erases_[which]; }
    /// Returns the number of operations that failed by fail_after(), fail_each_after() or worn bits.
    std::size_t failures() const { return failures_; }
    /// Returns how many reads of a sector had to wait for the end of an operation.
    std::size_t stalled_reads() const { return stalled_reads_; }
    /// Returns the sector and the word that were programmed last.
    std::pair<std::size_t, std::size_t> last_programmed() const { return last_programmed_; }
    bool is_locked() const { return locked_; }
    bool caches_data() const { return (access_control_ & stm32f405::flash_acr::data) != 0; }

  private:
    friend class SectorModel;

    std::uint32_t on_read(std::size_t offset) override;
    void on_write(std::size_t offset, std::uint32_t bits) override;
    void write_key(std::uint32_t key);
    void write_control(std::uint32_t bits);
    void erase();
    void cut_erase(SectorModel& sector);
    void program(SectorModel& sector, std::size_t word, std::uint32_t bits);
    enum class Outcome { done, cut, off, failed, failed_but_programmed };
    Outcome begin_operation();

    static constexpr std::size_t never_happens = std::numeric_limits<std::size_t>::max();

    stm32f405::FlashRegisters block_{};
    std::mt19937 random_;
    SectorModel first_, second_;
    std::uint32_t access_control_{stm32f405::flash_acr::data};
    std::uint32_t status_{0}, control_{0};
    bool locked_{true}, jammed_{false}, first_key_given_{false};
    std::size_t operations_{0}, operations_left_{never_happens}, until_failure_{never_happens};
    std::deque<bool> failing_programs_{};
    std::array<std::size_t, 2> erases_{};
    std::size_t failures_{0}, stalled_reads_{0};
    std::pair<std::size_t, std::size_t> last_programmed_{};
    std::uint32_t busy_reads_{0}, reads_an_operation_{3};
    bool stays_busy_{false}, hangs_{false};
    std::uint32_t failure_{write_protection_error};
};

}  // namespace canproof::test
