// SPDX-License-Identifier: Apache-2.0
// The relay of the AX130751 (1.4), connected to its objects.
#pragma once

#include "devices/ax130751/firmware/ax130751_output.hpp"
#include "devices/ax130751/firmware/digital_reading.hpp"
#include "devices/ax130751/firmware/relay.hpp"

namespace canproof::ax130751 {

class RelayOutput {
  public:
    RelayOutput(const ObjectDictionary& objects, const Sources& sources) noexcept
        : objects_{objects}, sources_{sources} {}

    /// Sets the relay to OFF. `powered`: the supply can drive the coil.
    void reset(bool powered, Outputs& outputs) noexcept;
    /// Evaluates the relay for one cycle and sets its contacts in `outputs`. No other block uses the state of the
    /// relay.
    void advance(const OutputCycle& cycle, Outputs& outputs) noexcept;
    /// Returns when the relay changes by itself with constant inputs.
    Instant next_change() const noexcept { return relay_.next_change(); }

  private:
    RelayPolarity polarity() const noexcept;
    RelayTimes times() const noexcept;
    OutputDrive drive_of(const BlockSignal& control, const RelayPolarity& polarity, bool shutdown) noexcept;
    static void show(bool on, bool powered, Outputs& outputs) noexcept;

    const ObjectDictionary& objects_;
    const Sources& sources_;
    SourceChoice control_choice_{};
    SourceChoice unlatch_choice_{};
    SourceChoice enable_choice_{};
    SourceChoice override_choice_{};
    Relay relay_{};
    DigitalReading control_{};
    DigitalReading unlatch_{};
    DigitalReading enable_{};
    DigitalReading override_{};
};

}  // namespace canproof::ax130751
