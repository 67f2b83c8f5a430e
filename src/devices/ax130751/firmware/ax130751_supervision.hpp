// SPDX-License-Identifier: Apache-2.0
// Supply and temperature of the AX130751 (1.8, chapter 4): measures them, compares them with their limits and shuts
// outputs off.
#pragma once

#include "devices/ax130751/firmware/limit_fault.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/ax130751/signals.hpp"

namespace canproof::ax130751 {

class Supervision {
  public:
    void reset() noexcept { *this = Supervision{}; }
    /// Sets 5020h power supply field value and 5030h processor temperature field value and detects faults.
    void advance(const generated::ax130751::Inputs& inputs, ObjectDictionary& objects) noexcept;

    bool has_supply_fault() const noexcept { return under_.is_present() || over_.is_present() || protects_; }
    bool has_temperature_fault() const noexcept { return temperature_.is_present(); }
    /// Returns whether the hardware is on: the supply is within the range of the hardware's own protection (chapter 4).
    bool has_power() const noexcept { return powered_; }
    /// Returns whether all outputs must be off.
    bool shuts_down() const noexcept { return shutdown_; }

  private:
    LimitFault under_{};
    LimitFault over_{};
    LimitFault temperature_{};
    bool powered_{false};
    bool protects_{false};  ///< the hardware has shut down, and the detection of supply faults is on
    bool shutdown_{false};
};

}  // namespace canproof::ax130751
