// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/peripheral.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <ostream>
#include <utility>

namespace canproof::test {

std::function<void(const Access&)> before_access;

namespace {

std::vector<Peripheral*>& all() {
    static std::vector<Peripheral*> peripherals;
    return peripherals;
}

std::uintptr_t number(const void* place) {
    return reinterpret_cast<std::uintptr_t>(place);
}

AccessLog* present_log = nullptr;

/// One access that has begun. A Window begins another one, of the model behind it.
class Begun {
  public:
    Begun() { ++count; }
    ~Begun() { --count; }
    Begun(const Begun&) = delete;
    Begun& operator=(const Begun&) = delete;
    Begun(Begun&&) = delete;
    Begun& operator=(Begun&&) = delete;

    /// Returns the log that lists this access, or nothing.
    static AccessLog* log() { return count == 1 ? present_log : nullptr; }
    /// Calls before_access() for an access that a Window has not begun.
    static void announce(const Access& access) {
        if (count == 0 && before_access) {
            before_access(access);
        }
    }

  private:
    static inline int count = 0;
};

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

std::ostream& operator<<(std::ostream& out, const Write& one) {
    return out << std::hex << std::setfill('0') << std::setw(8) << one.address << " = " << std::setw(8) << one.bits
               << std::dec << std::setfill(' ');
}

AccessLog::AccessLog() {
    present_log = this;
}

AccessLog::~AccessLog() {
    present_log = nullptr;
}

std::vector<Write> AccessLog::take_writes() {
    return std::exchange(writes_, {});
}

std::size_t AccessLog::reads_of(std::uintptr_t address) const {
    const auto found = reads_.find(address);
    return found == reads_.end() ? 0 : found->second;
}

}  // namespace canproof::test

namespace canproof::stm32f405 {

std::uint32_t Register::read() const noexcept {
    test::Begun::announce({test::number(this), false});
    const test::Begun access;
    if (test::AccessLog* const log = test::Begun::log()) {
        ++log->reads_[test::number(this)];
    }
    test::Peripheral& peripheral = test::peripheral_of(this);
    return peripheral.on_read(test::number(this) - peripheral.start_);
}

void Register::write(std::uint32_t bits) noexcept {
    test::Begun::announce({test::number(this), true});
    const test::Begun access;
    if (test::AccessLog* const log = test::Begun::log()) {
        log->writes_.push_back({test::number(this), bits});
    }
    test::Peripheral& peripheral = test::peripheral_of(this);
    peripheral.on_write(test::number(this) - peripheral.start_, bits);
}

}  // namespace canproof::stm32f405
