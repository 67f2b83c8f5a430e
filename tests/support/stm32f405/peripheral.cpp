// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/peripheral.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace canproof::test {

namespace {

std::vector<Peripheral*>& all() {
    static std::vector<Peripheral*> peripherals;
    return peripherals;
}

std::uintptr_t number(const void* place) {
    return reinterpret_cast<std::uintptr_t>(place);
}

}  // namespace

Peripheral::Peripheral(const void* start, std::size_t size) : start_{number(start)}, size_{size} {
    all().push_back(this);
}

Peripheral::~Peripheral() {
    all().erase(std::find(all().begin(), all().end(), this));
}

void Peripheral::fault(const std::string& what) {
    constexpr std::size_t most = 20;  // limits the list when a driver repeats the same fault
    if (faults_.size() < most) {
        faults_.push_back(what);
    }
}

/// Returns the model that contains a register. Without such a model the driver has a defect, and the test program is
/// aborted.
Peripheral& peripheral_of(const void* place) {
    for (Peripheral* one : all()) {
        if (number(place) >= one->start_ && number(place) - one->start_ < one->size_) {
            return *one;
        }
    }
    std::fputs("an access outside every register block\n", stderr);
    std::abort();
}

}  // namespace canproof::test

namespace canproof::stm32f405 {

std::uint32_t Register::read() const noexcept {
    test::Peripheral& peripheral = test::peripheral_of(this);
    return peripheral.on_read(test::number(this) - peripheral.start_);
}

void Register::write(std::uint32_t bits) noexcept {
    test::Peripheral& peripheral = test::peripheral_of(this);
    peripheral.on_write(test::number(this) - peripheral.start_, bits);
}

}  // namespace canproof::stm32f405
