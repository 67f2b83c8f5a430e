// SPDX-License-Identifier: Apache-2.0
// Plots of the worked examples in the AX130751's manual, configured over SDO on the simulated device.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::ax130751 {

/// Plots a joystick with a deadband that drives two outputs through two mirrored tables with two slopes each (1.5.3,
/// Figure 7).
host::LinePlot joystick_plot();

/// Plots a math block that adds 75 % of a joystick and 25 % of a potentiometer (1.7).
host::LinePlot trimmed_joystick_plot();

/// Plots a logic block that combines three lookup tables into one curve with 30 slopes (sections 1.5 and 1.6).
host::LinePlot thirty_slopes_plot();

}  // namespace canproof::ax130751
