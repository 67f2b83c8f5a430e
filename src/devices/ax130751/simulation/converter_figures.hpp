// The worked examples of the AX130751's manual, set up over SDO on the simulated device and drawn.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// 1.5.3, Figure 7: a joystick with a deadband drives two outputs through two mirrored tables with two slopes each.
LinePlot joystick_plot();

/// 1.7: a math block adds 75 % of a joystick and 25 % of a potentiometer.
LinePlot trimmed_joystick_plot();

/// 1.5, 1.6: a logic block makes 30 slopes out of three tables.
LinePlot thirty_slopes_plot();

}  // namespace canproof::host
