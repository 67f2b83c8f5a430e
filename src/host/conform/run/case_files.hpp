// The files of spec/conformance/, as the program carries them.
#pragma once

#include <map>
#include <string>

namespace canproof::host::conform {

/// Text by path.
const std::map<std::string, std::string>& case_files();

}  // namespace canproof::host::conform
