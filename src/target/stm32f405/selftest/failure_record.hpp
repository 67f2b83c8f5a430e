// SPDX-License-Identifier: Apache-2.0
// The record of the self-test that failed before a reset: two words of RAM that the start-up code does not initialise.
// A reset by the watchdog keeps RAM; after a loss of power its content is arbitrary, and the two words match only by a
// very rare chance.
#pragma once

#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

enum class SelfTest : std::uint8_t { none, core, stack, clock, ram, flash, outputs, flow, state };

/// Returns whether a failure of this test means failed hardware; a failure of the other tests means failed software.
constexpr bool finds_hardware(const SelfTest test) noexcept {
    return (test == SelfTest::core) || (test == SelfTest::clock) || (test == SelfTest::ram) ||
           (test == SelfTest::flash);
}

struct FailureWords {
    Register code;
    Register complement;
};

class FailureRecord {
  public:
    explicit FailureRecord(FailureWords& words) noexcept : words_{words} {}

    void keep(SelfTest test) noexcept;
    /// Returns the recorded test, or SelfTest::none, and clears the record.
    SelfTest take() noexcept;

  private:
    FailureWords& words_;
};

}  // namespace canproof::stm32f405
