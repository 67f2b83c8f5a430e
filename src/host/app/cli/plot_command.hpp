// SPDX-License-Identifier: Apache-2.0
// `canproof plot`: draws an SVG plot of the CSV file that `--outputs` of `run`, `panel` or `replay` wrote.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct PlotOptions {
    std::string csv;  ///< file that `--outputs` of `run`, `panel` or `replay` wrote
    std::string svg;  ///< file to write
    std::vector<std::string> signals;
};

/// Writes the SVG file. Returns the exit status.
int plot_outputs(const PlotOptions& options);

}  // namespace canproof::host
