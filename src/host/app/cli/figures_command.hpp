// `canproof figures`: what the devices do, drawn.
#pragma once

#include <string>

namespace canproof::host {

/// Writes SVG files into the folder. Returns the exit status.
int draw_figures(const std::string& folder);

}  // namespace canproof::host
