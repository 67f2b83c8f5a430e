// SPDX-License-Identifier: Apache-2.0
// All self-tests that need no knowledge of the device. They run completely before the device starts, and then in parts,
// one part in each pass of the main loop.
#pragma once

#include "target/stm32f405/selftest/clock_check.hpp"
#include "target/stm32f405/selftest/failure_record.hpp"
#include "target/stm32f405/selftest/flash_check.hpp"
#include "target/stm32f405/selftest/ram_check.hpp"
#include "target/stm32f405/selftest/stack_guard.hpp"

namespace canproof::stm32f405 {

/// The parts of an image's memory that the self-tests test.
struct ImageMemory {
    ByteView vectors;
    ByteView flash;  ///< ends with the CRC of the image (the seal)
    RamUnderTest ram;
    Slots<Register> stack_guard;
};

class SelfTests {
  public:
    SelfTests(const ImageMemory& memory, CaptureRegisters& capture, const std::uint32_t timer_mhz) noexcept
        : ram_{memory.ram},
          flash_{memory.vectors, memory.flash},
          guard_{memory.stack_guard},
          clock_{capture, timer_mhz} {}

    /// Tests registers and the whole RAM, and starts the other tests. The flash has been checked by is_sound_image().
    /// Returns the test that failed, or SelfTest::none.
    SelfTest start(Instant now) noexcept;
    /// Tests the stack guard and the clock, and in turns the registers, a slice of RAM or a slice of the flash, because
    /// a pass of the main loop must be short. Returns the first test that failed, or SelfTest::none.
    SelfTest step(Instant now) noexcept;

    const RamCheck& ram() const noexcept { return ram_; }
    const FlashCheck& flash() const noexcept { return flash_; }

  private:
    enum class Turn : std::uint8_t { core, ram, flash };

    SelfTest take_turn() noexcept;

    RamCheck ram_;
    FlashCheck flash_;
    StackGuard guard_;
    ClockCheck clock_;
    Turn turn_{Turn::core};
};

}  // namespace canproof::stm32f405
