// SPDX-License-Identifier: Apache-2.0
// The priorities that decide what drives an output: AX130751, Figure 4, with sections 1.2 to 1.4 and 1.8.
#pragma once

#include <cstdint>

#include "generated/ax130751/enumerations.hpp"

namespace canproof::ax130751 {

/// The action that the enable input demands (Tables 7 and 11).
using EnableAction = generated::ax130751::EnableAction;

/// The action of an output while an input is in error (Tables 2 and 9).
using FaultAction = generated::ax130751::FaultAction;

struct OutputConditions {
    /// A diagnostic fault, an NMT state other than operational, or an enable or override source without a value. For
    /// the relay also an input in error, an unlatch source without a value, and a polarity that does not implement it.
    bool shutdown{false};
    bool input_in_error{false};  ///< the control, enable or override input is in error
    FaultAction on_error{FaultAction::fault_value};
    bool overridden{false};                  ///< a valid override input is active
    EnableAction enable{EnableAction::run};  ///< the action that a valid enable input demands
};

/// The signal or the rule that drives the output.
enum class OutputDrive : std::uint8_t { control, shutdown, fault_value, override_value, shut_off, ramp_off, keep };

/// Returns what drives an output. The first that applies counts: a shutdown, an active override, an enable input that
/// does not permit the control, an input in error, or the control.
OutputDrive choose_drive(const OutputConditions& conditions) noexcept;

}  // namespace canproof::ax130751
