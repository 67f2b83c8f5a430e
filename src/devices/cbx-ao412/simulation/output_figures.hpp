// SPDX-License-Identifier: Apache-2.0
// A plot of the CBX-AO412's outputs.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::cbx_ao412 {

/// Plots a replay of the telegrams in the manual (7.10.2.3) followed by a staircase by RPDO: the output voltages that
/// the replay recorded.
host::LinePlot analog_outputs_plot();

}  // namespace canproof::cbx_ao412
