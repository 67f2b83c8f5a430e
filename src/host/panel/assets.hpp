// The files of page/ and views/ as they stood when the program was built, by name: `page/index.html`.
#pragma once

#include <map>
#include <string>

namespace canproof::host {

const std::map<std::string, std::string>& panel_assets();

}  // namespace canproof::host
