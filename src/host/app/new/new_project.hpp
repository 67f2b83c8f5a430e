// SPDX-License-Identifier: Apache-2.0
// Generates the files of a new project with one device, for `canproof new`.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

struct NewProject {
    std::string name;    ///< name of folder and device: small letters, digits, single dashes
    std::string prefix;  ///< prefix of the ids: capital letters and digits; empty: derived from the name
    std::string manual;  ///< title of the manual; empty: derived from the device
    std::string date;    ///< date of the manual, YYYY-MM-DD
    std::optional<Part>
        eds;  ///< identity and objects come from this data sheet; without it, they are those of the template
};

/// Returns the text of each file by its path. Throws InputError for an unusable name.
std::map<std::string, std::string> project_files(const NewProject& project);

}  // namespace canproof::host
