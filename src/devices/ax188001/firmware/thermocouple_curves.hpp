// The eight types of thermocouple that the AX188001 knows (1.1, Table 1), made of the register's tables.
#pragma once

#include "devices/ax188001/firmware/thermocouple.hpp"
#include "generated/ax188001/enumerations.hpp"

namespace canproof::ax188001 {

/// The functions of one type; they lie in flash.
const ThermocoupleCurve& thermocouple_curve(generated::ax188001::SensorType type) noexcept;

}  // namespace canproof::ax188001
