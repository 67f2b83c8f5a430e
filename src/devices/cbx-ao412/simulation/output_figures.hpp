// A plot of the CBX-AO412's outputs.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// CBX-AO412: the telegrams of its manual (7.10.2.3), then a staircase by RPDO, replayed; its outputs as replay wrote
/// them.
LinePlot analog_outputs_plot();

}  // namespace canproof::host
