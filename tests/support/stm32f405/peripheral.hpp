// Models of peripherals behind the registers of the drivers: each access of a Register comes to the model that holds
// it, so that reads and writes with side effects act at once. An access of no model, or of a gap in one, is a fault.
#pragma once

#include <cstddef>
#include <cstdint>
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

    /// What the driver did that the reference manual forbids or that has no effect.
    const std::vector<std::string>& faults() const { return faults_; }

  protected:
    /// Registers of `size` bytes from `start` on belong to this model as long as it lives.
    Peripheral(const void* start, std::size_t size);
    ~Peripheral();

    void fault(const std::string& what);

  private:
    friend class stm32f405::Register;
    friend Peripheral& peripheral_of(const void* place);

    /// `offset`: of the register, in bytes.
    virtual std::uint32_t on_read(std::size_t offset) = 0;
    virtual void on_write(std::size_t offset, std::uint32_t bits) = 0;

    std::uintptr_t start_;
    std::size_t size_;
    std::vector<std::string> faults_;
};

}  // namespace canproof::test
