// SPDX-License-Identifier: Apache-2.0
// The relay block (AX130751, 1.4): polarity with latch and unlatch, enable, override, delays.
#pragma once

#include "devices/ax130751/firmware/delayed_state.hpp"
#include "devices/ax130751/firmware/output_priority.hpp"
#include "devices/ax130751/firmware/switch_polarity.hpp"
#include "generated/ax130751/tables.hpp"

namespace canproof::ax130751 {

/// The effect of the unlatch input. The polarity of the relay determines this effect. The effect determines the rest
/// state of the latch.
using UnlatchEffect = generated::ax130751::relay_polarity::Unlatch;

struct RelayPolarity {
    SwitchPolarity answer{};
    UnlatchEffect unlatch{UnlatchEffect::ignored};
};

/// The times of a relay. Both delays are 0 when delays are disabled. `blink` is the time between two changes of a
/// blinking relay.
struct RelayTimes {
    Duration on_delay{};
    Duration off_delay{};
    Duration blink{};
};

struct RelayDemand {
    bool control{false};
    bool unlatch{false};
    bool override_state{false};
    bool is_valid{true};  ///< the control signal has a value and is not in error
};

class Relay {
  public:
    /// Returns the state at `now`. `drive` says which of the states in `demand` the relay takes, or that it is switched
    /// off or stays as it is. Call advance() in every cycle: it detects edges of the control signal between two calls.
    bool advance(OutputDrive drive, const RelayDemand& demand, const RelayPolarity& polarity, const RelayTimes& times,
                 Instant now) noexcept;
    /// Switches OFF at once and clears all states.
    void reset() noexcept { *this = Relay{}; }
    /// Returns when the relay changes by itself with constant inputs.
    Instant next_change() const noexcept { return earliest(delayed_.due(), next_blink_); }

    /// Returns whether the invariant between two calls holds (properties/invariants): while the relay does not blink,
    /// its state is its delayed state. It blinks only while its delayed state is ON. An unlatch input without effect
    /// does not unlatch it.
    bool is_consistent() const noexcept;

  private:
    /// The states of the latch, as section 1.4 of the manual describes unlatching.
    enum class Latch : std::uint8_t {
        latching,
        unlatched,  ///< the unlatch input is ON: the relay is at rest and ignores the control signal
        waiting     ///< the unlatch input is OFF again, but the control signal is not yet back at rest
    };

    void choose_polarity(const RelayPolarity& polarity) noexcept;
    void watch_unlatch(bool control, bool unlatch) noexcept;
    SwitchDrive follow_control(const RelayDemand& demand, const RelayPolarity& polarity, bool counts) noexcept;
    bool follow(SwitchDrive drive, const RelayTimes& times, Instant now) noexcept;
    bool force(bool state) noexcept;

    DelayedState delayed_{};
    Latch latch_{Latch::latching};
    UnlatchEffect effect_{UnlatchEffect::ignored};
    Instant blinking_since_{};
    Instant next_blink_{never};
    bool memory_{false};
    bool control_before_{false};
    bool was_valid_{true};
    bool blinking_{false};
    bool state_{false};
};

}  // namespace canproof::ax130751
