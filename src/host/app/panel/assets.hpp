// SPDX-License-Identifier: Apache-2.0
// The files of page/ and the devices' views, embedded at build time, by name: `page/index.html`, `views/ax130751.json`
// (src/devices/ax130751/simulation/panel.json).
#pragma once

#include <map>
#include <string>

namespace canproof::host {

const std::map<std::string, std::string>& panel_assets();

}  // namespace canproof::host
