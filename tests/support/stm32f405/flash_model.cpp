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

std::uint32_t SectorModel::on_read(std::size_t offset) {
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
    controller_.program(*this, cells_[offset / 4], bits);
}

void SectorModel::change(std::uint32_t& cell, std::uint32_t bits) {
    const auto place = static_cast<std::size_t>(&cell - cells_.data());
    if (is_cached_[place] && cell != bits) {
        stale_.emplace(place, cell);
    }
    cell = bits;
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
            return status_ | (busy_reads_ > 0 || stays_busy_ ? sr::busy : 0U);
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
    if (busy_reads_ > 0 || stays_busy_) {
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
    busy_reads_ = 3;
    stays_busy_ = stays_busy_ || std::exchange(hangs_, false);
    if (operations_left_ == 0) {
        return Outcome::off;
    }
    if (until_failure_ == 0 && !failing_programs_.empty()) {
        const bool programs = failing_programs_.front();
        failing_programs_.pop_front();
        status_ |= failure_;
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
    const std::size_t which = number == first_.number() ? 0 : 1;
    if (outcome != Outcome::off && outcome != Outcome::failed) {
        ++erases_[which];
        for (std::uint32_t& cell : sector(which).cells()) {
            const std::uint32_t set = outcome != Outcome::cut ? 0xFFFFFFFFU : static_cast<std::uint32_t>(random_());
            sector(which).change(cell, cell | set);
        }
    }
}

/// Programs a cell: changes the bits from 1 to 0 that are 0 in `bits`. After a power cut, some of these bits are still
/// 1.
void FlashModel::program(SectorModel& sector, std::uint32_t& cell, std::uint32_t bits) {
    if (locked_ || (control_ & cr::program) == 0) {
        status_ |= sequence_error;
        return fault("a word is written without leave to program");
    }
    if ((control_ & cr::by_words) != cr::by_words) {
        status_ |= parallelism_error;
        return;
    }
    switch (begin_operation()) {
        case Outcome::done:
        case Outcome::failed_but_programmed:
            sector.change(cell, cell & bits);
            return;
        case Outcome::cut:
            sector.change(cell, cell & (bits | static_cast<std::uint32_t>(random_())));
            return;
        default:
            return;
    }
}

}  // namespace canproof::test
