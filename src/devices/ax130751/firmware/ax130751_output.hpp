// SPDX-License-Identifier: Apache-2.0
// One universal output of the AX130751: the analogue block (1.3) and the digital block (1.2) on the same terminal.
#pragma once

#include "devices/ax130751/firmware/analogue_output.hpp"
#include "devices/ax130751/firmware/ax130751_sources.hpp"
#include "devices/ax130751/firmware/digital_output.hpp"
#include "devices/ax130751/firmware/digital_reading.hpp"
#include "devices/ax130751/firmware/linear_scaling.hpp"
#include "generated/ax130751/signals.hpp"

namespace canproof::ax130751 {

using Inputs = generated::ax130751::Inputs;
using Outputs = generated::ax130751::Outputs;

/// The conditions of a cycle that are the same for all outputs.
struct OutputCycle {
    bool shutdown{false};  ///< a diagnostic fault, or an NMT state other than operational, shuts the outputs off
    bool powered{true};    ///< the supply can drive the coil of the relay
    Instant now{};
};

class UniversalOutput {
  public:
    /// Creates output `number`, 1 or 2.
    UniversalOutput(ObjectDictionary& objects, const Sources& sources, const std::uint8_t number) noexcept
        : objects_{objects}, sources_{sources}, number_{number} {}

    void reset() noexcept;
    /// Drives the output and sets 7330h output field value and 2370h feedback field value. Returns true when one of
    /// them changes or a ramp is in progress.
    bool advance(const OutputCycle& cycle, const Inputs& inputs, Outputs& outputs) noexcept;
    /// Returns when the output changes by itself while advance() returns false: at the next change of a blinking
    /// output.
    Instant next_change() const noexcept { return digital_.next_change(); }

    /// Writes the defaults of the type in 6310h output type to digits, scaling, override value and fault value. Does
    /// nothing when 5550h (enable automatic updates) is 0, or when the type is 0 (not used) or unknown.
    void take_type_defaults() noexcept;
    /// Checks a new value of 7321h or 7323h scaling, 2300h override or 7341h fault field value against the range of the
    /// output type. Returns 06090031h above the range and 06090032h below it. Returns AbortCode::none within it, for 0
    /// (OFF), and while the output has no type.
    AbortCode check_field_value(std::int16_t field_value) const noexcept;

  private:
    using Kind = generated::ax130751::output_type::Kind;

    /// The present control, enable and override signals of the output.
    struct InputSignals {
        BlockSignal control{};
        BlockSignal enable{};
        BlockSignal override_input{};
    };

    /// Switches the output OFF if 6310h output type has changed since the last cycle. Returns true when 7330h or 2370h
    /// (output and feedback field value) changed as a result.
    bool follow_type() noexcept;
    InputSignals read_inputs() noexcept;
    OutputDrive drive_of(const InputSignals& signals, bool shutdown, bool digital) noexcept;
    OutputDrive error_drive(bool digital) const noexcept;
    double control_value(const BlockSignal& control, const LinearScaling& scaling) const noexcept;
    double carried(Kind kind, double value, const Inputs& inputs) const noexcept;
    /// The physical values of the parameters as last computed. The parameters are read in every cycle but rarely
    /// written. This cache depends on the integer of each parameter and its digits, 6302h (AO Decimal Digits PV) or
    /// 6332h (AO Decimal Digits FV).
    struct KeptParameters {
        KeptPhysicalValue scaling_1_pv{};
        KeptPhysicalValue scaling_2_pv{};
        KeptPhysicalValue scaling_1_fv{};
        KeptPhysicalValue scaling_2_fv{};
        KeptPhysicalValue override_fv{};
        KeptPhysicalValue fault_fv{};
    };

    LinearScaling scaling() noexcept;
    AnalogueDemand demand(double control) noexcept;
    bool advance_analogue(const InputSignals& signals, const OutputCycle& cycle, const Inputs& inputs,
                          Outputs& outputs) noexcept;
    bool advance_digital(const InputSignals& signals, const OutputCycle& cycle, Outputs& outputs) noexcept;
    void drive_analogue(Kind kind, double value, Outputs& outputs) const noexcept;
    void clear(Outputs& outputs) const noexcept;
    double level() const noexcept;
    SwitchPolarity polarity() const noexcept;
    /// Sets 7330h (AO Output Field Value) and 2370h (AO Feedback Field Value). Returns true when one of them changes.
    bool show(std::int16_t target, std::int16_t feedback) noexcept;

    ObjectDictionary& objects_;
    const Sources& sources_;
    std::uint8_t number_;
    SourceChoice control_choice_{};
    SourceChoice enable_choice_{};
    SourceChoice override_choice_{};
    KeptParameters parameters_{};
    AnalogueOutput analogue_{};
    DigitalOutput digital_{};
    DigitalReading control_{};
    DigitalReading enable_{};
    DigitalReading override_{};
    std::uint16_t type_{0U};
};

}  // namespace canproof::ax130751
