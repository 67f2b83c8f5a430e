// SPDX-License-Identifier: Apache-2.0
// Plots of the AX060805: a tumble through all orientations, the error of the computed angles, the input filter.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::ax060805 {

/// Plots pitch, roll and gravity angle as TPDO1 carries them. Pitch and roll are tilt angles, as in a shipped unit. The
/// unit makes one turn about Y, one about X and one about the line between them, 20 s each.
host::LinePlot tumble_plot();

/// Plots the tumble of tumble_plot() with Euler angles: pitch stays within 90 degrees, and roll jumps by half a turn
/// when the X axis is vertical.
host::LinePlot euler_tumble_plot();

/// Plots the error of the single-precision angles against the manual's formulae (2.1.4) in double precision, over the
/// tumble of tumble_plot().
host::LinePlot angle_error_plot();

/// Plots a step of the pitch from 0 to 30 degrees after the input filter, for three cut-off frequencies.
host::LinePlot settling_plot();

}  // namespace canproof::ax060805
