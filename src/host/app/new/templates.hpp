// SPDX-License-Identifier: Apache-2.0
// The files of src/host/app/new/template/, embedded in the program.
#pragma once

#include <map>
#include <string>

namespace canproof::host {

/// Returns the text of each file by its path; text and path contain @names@ as placeholders.
const std::map<std::string, std::string>& project_templates();

}  // namespace canproof::host
