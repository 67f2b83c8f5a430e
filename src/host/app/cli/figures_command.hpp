// SPDX-License-Identifier: Apache-2.0
// `canproof figures`: plots of the devices' behaviour.
#pragma once

#include <string>

namespace canproof::host {

/// Writes the plots as SVG files into the folder. Returns the exit status.
int draw_figures(const std::string& folder);

}  // namespace canproof::host
