// SPDX-License-Identifier: Apache-2.0
// Generates the files of a new project with one device, for `canproof new`.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

struct NewProject {
    std::string name;         ///< name of folder and device: small letters, digits, single dashes
    std::string prefix;       ///< prefix of the ids of requirements and decisions; empty: derived from the name
    std::string manual;       ///< title of the manual; empty: derived from the device
    std::string date;         ///< date of the manual, YYYY-MM-DD
    std::optional<Part> eds;  ///< data sheet with identity and objects; without it, the template provides them
};

/// Returns the text of each file by its path. Throws InputError for a name or prefix that cannot be used.
std::map<std::string, std::string> project_files(const NewProject& project);

}  // namespace canproof::host
