// What the AX060805 does, drawn: a tumble through all orientations, the error of its arithmetic, its input filter.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// One turn about Y, one about X and one about the line between them, 20 s each: pitch, roll and gravity angle as TPDO1
/// carries them, tilt angles as shipped.
LinePlot tumble_plot();

/// The same tumble with Euler angles: pitch stays within 90 degrees, and roll turns over at the vertical.
LinePlot euler_tumble_plot();

/// Error of the single-precision angles against the formulae of 2.1.4 in double precision, over the same tumble.
LinePlot angle_error_plot();

/// A step of the pitch from 0 to 30 degrees behind the input filter, for three cut-off frequencies.
LinePlot settling_plot();

}  // namespace canproof::host
