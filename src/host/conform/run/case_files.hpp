// SPDX-License-Identifier: Apache-2.0
// The files of spec/conformance/, embedded in the program.
#pragma once

#include <map>
#include <string>

namespace canproof::host::conform {

/// Returns the text of each file by path.
const std::map<std::string, std::string>& case_files();

}  // namespace canproof::host::conform
