// `canproof plot`: what --outputs wrote, drawn.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct PlotOptions {
    std::string csv;  ///< what --outputs wrote
    std::string svg;  ///< file to write
    std::vector<std::string> signals;
};

/// Writes the SVG file. Returns the exit status.
int plot_outputs(const PlotOptions& options);

}  // namespace canproof::host
