// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/ram_model.hpp"

#include "tests/support/stm32f405/core_model.hpp"

namespace canproof::test {

void RamModel::set(const Cell& cell, bool value) {
    const std::uint32_t mask = 1U << cell.bit;
    content_[cell.word] = value ? content_[cell.word] | mask : content_[cell.word] & ~mask;
}

void RamModel::note_access() {
    ++accesses_;
    unmasked_ += core_model().masked ? 0 : 1;
}

std::uint32_t RamModel::on_read(std::size_t offset) {
    note_access();
    const bool disturbed = fault_now() == Fault::state && is_set(defect_.aggressor) == defect_.edge;
    if (fault_now() == Fault::stuck || disturbed) {
        set(defect_.victim, defect_.value);
    }
    return content_.at(offset / 4);
}

void RamModel::on_write(std::size_t offset, std::uint32_t bits) {
    note_access();
    const bool victim_before = is_set(defect_.victim), aggressor_before = is_set(defect_.aggressor);
    content_.at(offset / 4) = bits;
    const bool changes = is_set(defect_.aggressor) != aggressor_before && is_set(defect_.aggressor) == defect_.edge;
    switch (fault_now()) {
        case Fault::transition:
            if (is_set(defect_.victim) == defect_.value && victim_before != defect_.value) {
                set(defect_.victim, victim_before);
            }
            return;
        case Fault::address:
            if (offset / 4 == defect_.aggressor.word) {
                content_.at(defect_.victim.word) = bits;
            }
            return;
        case Fault::inversion:
            if (changes) {
                set(defect_.victim, !is_set(defect_.victim));
            }
            return;
        case Fault::idempotent:
            if (changes) {
                set(defect_.victim, defect_.value);
            }
            return;
        default:
            return;
    }
}

}  // namespace canproof::test
