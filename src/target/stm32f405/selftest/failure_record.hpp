// SPDX-License-Identifier: Apache-2.0
// The record of the self-test that failed before a reset: two words of RAM that the start-up code does not initialise.
// A reset by the watchdog keeps RAM; after a loss of power its content is arbitrary, and the two words match only by a
// very rare chance.
#pragma once

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/register.hpp"

namespace canproof::stm32f405 {

enum class SelfTest : std::uint8_t { none, core, stack, clock, ram, flash, outputs, flow, state };

/// Returns whether a failure of this test means failed hardware; a failure of the other tests means failed software.
constexpr bool finds_hardware(const SelfTest test) noexcept {
    return (test == SelfTest::core) || (test == SelfTest::clock) || (test == SelfTest::ram) ||
           (test == SelfTest::flash);
}

/// The failures that a device reports after its start.
struct StartFaults {
    bool software{false};
    bool hardware{false};
};

/// Returns what a device reports after a failed self-test (SelfTest::none when there is no record), after a reset by
/// the watchdog, or when it runs without its crystal. A reset by the watchdog without a record follows an exception or
/// a hang of the software.
static_assert(implements<req::CO_SELF_016>);
constexpr StartFaults faults_at_start(const SelfTest failed, const bool was_reset_by_watchdog,
                                      const bool has_crystal) noexcept {
    const bool failed_hardware = finds_hardware(failed);
    const bool failed_software = (failed == SelfTest::none) ? was_reset_by_watchdog : !failed_hardware;
    return StartFaults{failed_software, failed_hardware || !has_crystal};
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
