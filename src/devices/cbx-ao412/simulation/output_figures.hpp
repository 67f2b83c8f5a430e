// SPDX-License-Identifier: Apache-2.0
// A plot of the CBX-AO412's outputs.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::cbx_ao412 {

/// Plots the output voltages during a replay: first the telegrams of the manual (7.10.2.3), then a staircase that RPDOs
/// set.
host::LinePlot analog_outputs_plot();

}  // namespace canproof::cbx_ao412
