// The files of page/ and the devices' views as they stood when the program was built, by name: `page/index.html`,
// `views/ax130751.json` (src/devices/ax130751/simulation/panel.json).
#pragma once

#include <map>
#include <string>

namespace canproof::host {

const std::map<std::string, std::string>& panel_assets();

}  // namespace canproof::host
