// Supply and temperature of the AX130751 (1.8, chapter 4): measured, compared with their limits, and what they shut
// off.
#pragma once

#include "devices/ax130751/firmware/limit_fault.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/ax130751/signals.hpp"

namespace canproof::ax130751 {

class Supervision {
  public:
    void reset() noexcept { *this = Supervision{}; }
    /// Sets 5020h and 5030h and looks for faults.
    void advance(const generated::ax130751::Inputs& inputs, ObjectDictionary& objects) noexcept;

    bool has_supply_fault() const noexcept { return under_.is_present() || over_.is_present(); }
    bool has_temperature_fault() const noexcept { return temperature_.is_present(); }
    /// Whether the hardware is on: within the range of its own protection (chapter 4).
    bool has_power() const noexcept { return powered_; }
    /// Whether all outputs are to be off.
    bool shuts_down() const noexcept { return shutdown_; }

  private:
    LimitFault under_{};
    LimitFault over_{};
    LimitFault temperature_{};
    bool powered_{false};
    bool shutdown_{false};
};

}  // namespace canproof::ax130751
