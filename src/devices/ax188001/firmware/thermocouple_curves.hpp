// SPDX-License-Identifier: Apache-2.0
// The eight types of thermocouple of the AX188001 (1.1, Table 1), built from the tables of the requirements register.
#pragma once

#include "devices/ax188001/firmware/thermocouple.hpp"
#include "generated/ax188001/enumerations.hpp"

namespace canproof::ax188001 {

/// Returns the curve of one type, which lies in flash: its reference functions and its inverse functions. Returns the
/// curve of type J for an unknown type.
const ThermocoupleCurve& thermocouple_curve(generated::ax188001::SensorType type) noexcept;

}  // namespace canproof::ax188001
