// SPDX-License-Identifier: Apache-2.0
// The files of page/ and the view of each device, embedded at build time, by name: `page/index.html`,
// `views/ax130751.json` (the file src/devices/ax130751/simulation/panel.json).
#pragma once

#include <map>
#include <string>

namespace canproof::host {

const std::map<std::string, std::string>& panel_assets();

}  // namespace canproof::host
