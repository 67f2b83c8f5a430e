// What the AX188001 does, drawn: how far its conversion is from the ITS-90, how far the whole channel is from the hot
// junction, and a ramp through all limits with a wire that breaks.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// Error in °C of the inversion alone, for each type over its range.
LinePlot conversion_error_plot();

/// Error in °C of the published inverse functions by themselves: why their result is only where the inversion begins.
LinePlot inverse_error_plot();

/// Error in °C of the field value 6100h against the hot junction: converter, gain and conversion together.
LinePlot channel_error_plot();

/// A ramp at 10 °C a second through all limits and back, the wire broken for nine seconds: hot junction, process value
/// as TPDO1 carries it, and each emergency message.
LinePlot ramp_plot();

}  // namespace canproof::host
