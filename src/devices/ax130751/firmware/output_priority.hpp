// SPDX-License-Identifier: Apache-2.0
// The priorities that decide what drives an output: AX130751, Figure 4, with sections 1.2 to 1.4 and 1.8.
#pragma once

#include "generated/ax130751/enumerations.hpp"

namespace canproof::ax130751 {

/// The signal or the rule that determines the state or value of the output or of the relay.
using OutputDrive = generated::ax130751::OutputDrive;

struct OutputConditions {
    /// A diagnostic fault, an NMT state other than operational, or an enable or override source without a value. For
    /// the relay also an input in error, an unlatch source without a value, and a polarity that does not implement it.
    bool shutdown{false};
    bool input_in_error{false};                      ///< the control, enable or override input is in error
    OutputDrive on_error{OutputDrive::fault_value};  ///< fault_value or keep (Tables 2 and 9)
    bool overridden{false};                          ///< a valid override input is active
    OutputDrive enable{OutputDrive::control};  ///< control, or what a valid enable input demands (Tables 7 and 11)
};

/// Returns what drives an output. The first of these that applies decides: a shutdown, an active override, an enable
/// input that does not let the control signal drive the output, an input in error. If none applies, the control signal
/// drives the output.
OutputDrive choose_drive(const OutputConditions& conditions) noexcept;

}  // namespace canproof::ax130751
