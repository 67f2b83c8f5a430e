// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/flash_model.hpp"

#include <algorithm>
#include <utility>

namespace canproof::test {

namespace {

namespace acr = stm32f405::flash_acr;
namespace sr = stm32f405::flash_sr;
namespace cr = stm32f405::flash_cr;

// Flags of FLASH_SR (RM0090 3.9.5), repeated here to check the driver's own definitions.
constexpr std::uint32_t all_flags = 0xF3;
constexpr std::uint32_t parallelism_error = 1U << 6U;
constexpr std::uint32_t sequence_error = 1U << 7U;

}  // namespace

SectorModel::SectorModel(FlashModel& controller, std::uint32_t number, std::size_t words)
    : SectorModel{controller, number, std::vector<std::uint32_t>(words, 0xFFFFFFFFU)} {}

SectorModel::SectorModel(FlashModel& controller, std::uint32_t number, std::vector<std::uint32_t> cells)
    : Peripheral{cells.data(), cells.size() * sizeof cells[0]},
      controller_{controller},
      number_{number},
      cells_{std::move(cells)},
      is_cached_(cells_.size()) {}

/// A read waits until the flash is ready (RM0090 3.6).
std::uint32_t SectorModel::on_read(std::size_t offset) {
    controller_.stalled_reads_ += controller_.is_busy() ? 1 : 0;
    controller_.end_operation();
    if (!controller_.caches_data()) {
        return cells_[offset / 4];
    }
    // A line of the data cache keeps its old content after a change of the cell, until the cache is reset (RM0090
    // 3.5.2).
    is_cached_[offset / 4] = true;
    const auto old = stale_.find(offset / 4);
    return old == stale_.end() ? cells_[offset / 4] : old->second;
}

void SectorModel::on_write(std::size_t offset, std::uint32_t bits) {
    controller_.program(*this, offset / 4, bits);
}

void SectorModel::change(std::size_t word, std::uint32_t bits) {
    const auto worn = worn_.find(word);
    const std::uint32_t now = worn == worn_.end() ? bits : (bits | worn->second.first) & ~worn->second.second;
    if (is_cached_[word] && cells_[word] != now) {
        stale_.emplace(word, cells_[word]);
    }
    cells_[word] = now;
}

void SectorModel::forget_cached() {
    std::fill(is_cached_.begin(), is_cached_.end(), false);
    stale_.clear();
}

FlashModel::FlashModel(std::uint32_t seed, std::size_t words)
    : Peripheral{&block_, sizeof block_}, random_{seed}, first_{*this, 2, words}, second_{*this, 3, words} {}

void FlashModel::restore_power() {
    operations_left_ = until_failure_ = never_happens;
    status_ = control_ = busy_reads_ = 0;
    stays_busy_ = hangs_ = false;
    access_control_ = acr::data;
    first_.forget_cached();
    second_.forget_cached();
    locked_ = true;
    jammed_ = first_key_given_ = false;
}

std::uint32_t FlashModel::on_read(std::size_t offset) {
    switch (offset) {
        case 0x00:
            return access_control_;
        case 0x0C:
            busy_reads_ -= busy_reads_ > 0 ? 1 : 0;
            return status_ | (is_busy() ? sr::busy : 0U);
        case 0x10:
            return control_ | (locked_ ? cr::lock : 0U);
        default:
            fault("a read of a key or an option");
            return 0;
    }
}

void FlashModel::on_write(std::size_t offset, std::uint32_t bits) {
    switch (offset) {
        case 0x00:
            if ((bits & acr::reset_data) != 0 && (bits & acr::data) != 0) {
                fault("the data cache is reset while it is on");
            }
            access_control_ = bits;
            if ((bits & acr::reset_data) != 0) {
                first_.forget_cached();
                second_.forget_cached();
            }
            return;
        case 0x04:
            return write_key(bits);
        case 0x0C:
            status_ &= ~(bits & all_flags);
            return;
        case 0x10:
            return write_control(bits);
        default:
            fault("a write to an option");
    }
}

void FlashModel::write_key(std::uint32_t key) {
    if (!first_key_given_ && key == 0x45670123U) {
        first_key_given_ = true;
    } else if (first_key_given_ && key == 0xCDEF89ABU && !jammed_) {
        locked_ = first_key_given_ = false;
    } else {
        jammed_ = true;
        fault("a wrong key locks the controller until the next reset");
    }
}

void FlashModel::write_control(std::uint32_t bits) {
    if (is_busy()) {
        fault("FLASH_CR is written while the controller is busy");
    } else if ((bits & cr::lock) != 0) {
        locked_ = true;
        control_ = 0;
    } else if (locked_) {
        fault("FLASH_CR is written while it is locked");
    } else {
        control_ = bits & ~cr::start;
        if ((bits & cr::start) != 0) {
            erase();
        }
    }
}

FlashModel::Outcome FlashModel::begin_operation() {
    busy_reads_ = reads_an_operation_;
    stays_busy_ = stays_busy_ || std::exchange(hangs_, false);
    if (operations_left_ == 0) {
        return Outcome::off;
    }
    if (until_failure_ == 0 && !failing_programs_.empty()) {
        const bool programs = failing_programs_.front();
        failing_programs_.pop_front();
        status_ |= failure_;
        ++failures_;
        return programs ? Outcome::failed_but_programmed : Outcome::failed;
    }
    until_failure_ -= until_failure_ > 0 ? 1 : 0;
    ++operations_;
    if (operations_left_ != never_happens && --operations_left_ == 0) {
        return Outcome::cut;
    }
    return Outcome::done;
}

void FlashModel::erase() {
    const std::uint32_t number = control_ >> cr::sector_shift & 0xFU;
    if ((control_ & cr::erase_sector) == 0 || (number != first_.number() && number != second_.number())) {
        return fault("an erase of what is no sector of the journal");
    }
    const Outcome outcome = begin_operation();
    if (outcome == Outcome::off || outcome == Outcome::failed) {
        return;
    }
    const std::size_t which = number == first_.number() ? 0 : 1;
    ++erases_[which];
    SectorModel& erased = sector(which);
    if (outcome == Outcome::cut) {
        return cut_erase(erased);
    }
    for (std::size_t word = 0; word < erased.cells().size(); ++word) {
        erased.change(word, 0xFFFFFFFFU);
    }
}

/// After a power cut, a sector is as before, erased up to a word, or has any bits at 1 that were 0.
void FlashModel::cut_erase(SectorModel& sector) {
    const std::size_t words = sector.cells().size();
    const std::size_t erased = random_() % 2 == 0 ? random_() % (words + 1) : 0;
    const bool others_stay = random_() % 2 == 0;
    for (std::size_t word = 0; word < words; ++word) {
        const std::uint32_t some = others_stay ? 0U : static_cast<std::uint32_t>(random_());
        sector.change(word, word < erased ? 0xFFFFFFFFU : sector.cells()[word] | some);
    }
}

/// Programs a cell: changes the bits from 1 to 0 that are 0 in `bits`. After a power cut, some of these bits are still
/// 1.
void FlashModel::program(SectorModel& sector, std::size_t word, std::uint32_t bits) {
    if (is_busy()) {
        return fault("a word is written while the controller is busy");
    }
    if (locked_ || (control_ & cr::program) == 0) {
        status_ |= sequence_error;
        return fault("a word is written without leave to program");
    }
    if ((control_ & cr::by_words) != cr::by_words) {
        status_ |= parallelism_error;
        return;
    }
    const Outcome outcome = begin_operation();
    if (outcome == Outcome::off || outcome == Outcome::failed) {
        return;
    }
    const std::uint32_t kept = outcome == Outcome::cut ? static_cast<std::uint32_t>(random_()) : 0U;
    sector.change(word, sector.cells()[word] & (bits | kept));
    const bool fails_by_wear = sector.worn_.count(word) != 0 && sector.cells()[word] != bits;
    failures_ += outcome == Outcome::done && fails_by_wear ? 1 : 0;
    last_programmed_ = {&sector == &first_ ? 0U : 1U, word};
}

}  // namespace canproof::test
