// All plots of the devices' behaviour.
#pragma once

#include <map>
#include <string>

#include "host/plot/line_plot.hpp"

namespace canproof::host {

/// By file name, which begins with the name of the device.
std::map<std::string, LinePlot> all_figures();

}  // namespace canproof::host
