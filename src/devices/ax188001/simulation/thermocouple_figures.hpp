// SPDX-License-Identifier: Apache-2.0
// Plots of the AX188001: the error of its conversion against the ITS-90, and the error of the whole channel compared
// with the temperature of the hot junction. Another plot is a ramp through all limits with a wire that breaks.
#pragma once

#include "host/report/line_plot.hpp"

namespace canproof::ax188001 {

/// Plots the error in °C of the conversion from voltage to temperature alone, for each type over its range; type B
/// begins at 42 °C.
host::LinePlot conversion_error_plot();

/// Plots the error in °C of the published inverse functions alone. It shows why their result is only the start value of
/// the conversion.
host::LinePlot inverse_error_plot();

/// Plots the error in °C of 6100h (input field value) compared with the hot junction: the errors of converter, gain and
/// conversion together.
host::LinePlot channel_error_plot();

/// Plots a ramp at 10 °C per second through all limits and back, with the wire broken for nine seconds: hot junction,
/// process value in TPDO1, and each emergency message.
host::LinePlot ramp_plot();

}  // namespace canproof::ax188001
