// The files of src/host/app/new/template/, as the program carries them.
#pragma once

#include <map>
#include <string>

namespace canproof::host {

/// Text by path, both with @names@ to be filled in.
const std::map<std::string, std::string>& project_templates();

}  // namespace canproof::host
