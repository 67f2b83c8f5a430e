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

/// What a cycle gives all outputs.
struct OutputCycle {
    bool shutdown{false};  ///< a diagnostic fault, or a state other than operational, shuts them off
    bool powered{true};    ///< the coil of the relay can be supplied
    Instant now{};
};

class UniversalOutput {
  public:
    /// `number` 1 or 2.
    UniversalOutput(ObjectDictionary& objects, const Sources& sources, const std::uint8_t number) noexcept
        : objects_{objects}, sources_{sources}, number_{number} {}

    void reset() noexcept;
    /// Drives the output, 7330h and 2370h. True when they changed or a ramp is under way.
    bool advance(const OutputCycle& cycle, const Inputs& inputs, Outputs& outputs) noexcept;
    /// When it will change by itself, its inputs staying as they are.
    Instant next_change() const noexcept { return digital_.next_change(); }

    /// Writes what belongs to the type in 6310h (5550h).
    void take_type_defaults() noexcept;
    /// Whether 7321h, 7323h, 2300h and 7341h may take a value.
    AbortCode check_field_value(std::int16_t field_value) const noexcept;

  private:
    using Kind = generated::ax130751::output_type::Kind;

    /// Control, enable and override at this moment.
    struct InputSignals {
        BlockSignal control{};
        BlockSignal enable{};
        BlockSignal override_input{};
    };

    /// Starts from OFF when 6310h (AO output type) has changed. True when 7330h or 2370h changed with it.
    bool follow_type() noexcept;
    InputSignals read_inputs() noexcept;
    OutputDrive drive_of(const InputSignals& signals, bool shutdown, bool digital) noexcept;
    FaultAction fault_action(bool digital) const noexcept;
    double control_value(const BlockSignal& control, const LinearScaling& scaling) const noexcept;
    double carried(Kind kind, double value, const Inputs& inputs) const noexcept;
    /// What a parameter last stood for: rarely written, and read in every cycle. Keys of this cache: the integer of
    /// each and its digits, 6302h or 6332h.
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
    /// Sets 7330h and 2370h. True when they were others.
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
