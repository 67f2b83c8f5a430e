// What `--outputs` wrote, drawn: each signal holds its value until the next line that names it.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "host/report/line_plot.hpp"

namespace canproof::host {

/// A curve for each of `signals`, in that order; without any, for each signal that changes, in order of appearance.
/// Throws InputError for a line that is not `seconds,signal,value`, for a signal that the file lacks, and when nothing
/// is left to draw. `name` stands in messages and as the title.
LinePlot output_plot(std::istream& csv, const std::string& name, const std::vector<std::string>& signals);

}  // namespace canproof::host
