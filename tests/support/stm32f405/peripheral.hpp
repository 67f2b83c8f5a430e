// SPDX-License-Identifier: Apache-2.0
// The base class of models of peripherals. Each access of a driver to a Register goes to the model that has this
// register, so that side effects of reads and writes happen at once. An access to an address between the registers of a
// model is recorded as a fault. An access to a register that belongs to no model ends the test program. AccessLog lists
// the accesses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "target/stm32f405/register.hpp"

namespace canproof::test {

class Peripheral {
  public:
    Peripheral(const Peripheral&) = delete;
    Peripheral& operator=(const Peripheral&) = delete;
    Peripheral(Peripheral&&) = delete;
    Peripheral& operator=(Peripheral&&) = delete;

    /// Returns what the driver did although the reference manual forbids it or it has no effect.
    const std::vector<std::string>& faults() const { return faults_; }

  protected:
    /// Assigns the registers of `size` bytes from `start` on to this model for its lifetime.
    Peripheral(const void* start, std::size_t size);
    ~Peripheral();

    void fault(const std::string& what);

  private:
    friend class stm32f405::Register;
    friend Peripheral& peripheral_of(const void* place);

    /// `offset` is the offset of the register from the start of the model, in bytes.
    virtual std::uint32_t on_read(std::size_t offset) = 0;
    virtual void on_write(std::size_t offset, std::uint32_t bits) = 0;

    std::uintptr_t start_;
    std::size_t size_;
    std::vector<std::string> faults_;
};

/// One access of a driver to the register at an address.
struct Access {
    std::uintptr_t address;
    bool is_write;
};

/// If a test sets it: called before each access of a driver, but not for an access that a Window passes on to a model.
extern std::function<void(const Access&)> before_access;

/// One write of a driver to the register at an address.
struct Write {
    std::uintptr_t address;
    std::uint32_t bits;

    friend bool operator==(const Write& a, const Write& b) { return a.address == b.address && a.bits == b.bits; }
    friend std::ostream& operator<<(std::ostream& out, const Write& one);
};

/// Lists the accesses of drivers to registers while it exists. An access that a Window passes on to a model is listed
/// once, with the address of the chip.
class AccessLog {
  public:
    AccessLog();
    ~AccessLog();
    AccessLog(const AccessLog&) = delete;
    AccessLog& operator=(const AccessLog&) = delete;
    AccessLog(AccessLog&&) = delete;
    AccessLog& operator=(AccessLog&&) = delete;

    /// Returns the writes since the last call, in their order.
    std::vector<Write> take_writes();
    /// Returns how often the register at an address was read.
    std::size_t reads_of(std::uintptr_t address) const;

  private:
    friend class stm32f405::Register;

    std::vector<Write> writes_;
    std::map<std::uintptr_t, std::size_t> reads_;
};

}  // namespace canproof::test
