// SPDX-License-Identifier: Apache-2.0
// Plots the file that `canproof COMMAND --outputs` writes. Each signal keeps its value until the next line of this
// signal.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// Returns a curve for each of `signals`, in their order. If `signals` is empty, returns a curve for each signal with
/// at least two lines in the file, in the order of their second lines. `name` appears in messages and as the title.
/// Throws InputError for a line that is not `seconds,signal,value`, for a signal that the file does not contain, and
/// when there is nothing to draw.
LinePlot output_plot(std::istream& csv, const std::string& name, const std::vector<std::string>& signals);

}  // namespace canproof::host
